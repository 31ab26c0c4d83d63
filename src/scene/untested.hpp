// Pairs that are not tested: those that the scene does not ask about, and the others, with the reason.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "taut/coverage.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Of a coverage that is_empty(): that nothing was tested, why, and the remedy.
std::string why_untested(const Coverage& coverage);

/// For the title of a picture: "; 2 pairs not tested", "; nothing was tested", or nothing if all pairs were tested.
std::string untested_note(const Coverage& coverage);

/// The coverage of an answer whose search was stopped before bodies were prepared: no pair was reached. Ignored pairs
/// are counted as such. Throws InputError if the scene ignores bodies that do not exist.
Coverage coverage_before_search(const Scene& scene);

/// The coverage of an answer whose search was stopped after so many pairs: all others that the question is about were
/// not reached.
Coverage coverage_when_stopped(Coverage coverage, std::uint64_t tested);

// Which pairs of bodies a scene does not ask about.

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
  /// Is there a pair of the body with a single other one?
  bool names(int body) const;

  void add(int a, int b);
  void add_all(int body) { all_[static_cast<std::size_t>(body)] = true; }
  /// One more, which the scene does not name.
  void add_body() { all_.push_back(everything_); }
  void remove_last_body() { all_.pop_back(); }

 private:
  bool everything_ = false;  ///< every pair, whatever bodies there are
  std::vector<bool> all_;
  std::vector<std::pair<int, int>> pairs_;
};

}  // namespace taut::internal
