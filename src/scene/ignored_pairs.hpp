// Which pairs of bodies a scene does not ask about.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "taut/scene.hpp"

namespace taut::internal {

/// Bodies by their names; of a name that is given twice, the first one.
std::map<std::string, int> bodies_by_name(const Scene& scene);

/// A scene's list by indices, with every body that is ignored altogether.
class IgnoredPairs {
 public:
  IgnoredPairs() = default;
  /// The scene must be valid.
  explicit IgnoredPairs(const Scene& scene);

  bool has(int a, int b) const;
  /// Is the body ignored by every other one?
  bool has_all(int body) const { return all_[static_cast<std::size_t>(body)]; }
  /// The number of pairs that are ignored.
  std::uint64_t count() const;
  /// Those given one by one: in order, each once, with the smaller index first.
  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }

 private:
  std::vector<bool> all_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace taut::internal
