// The bodies of a problem about paths, as a verifier of logs about paths sees them.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/untested.hpp"
#include "taut/path.hpp"

namespace taut::internal::proof {

struct PartShape {
  std::vector<Polygon> rings;  ///< its outline, then its holes
  Layers z;
};
struct BodyShape {
  std::vector<PartShape> parts;
  std::vector<int> chain;  ///< itself, its parent, and so on
};

class PathBodies {
 public:
  /// The problem must be valid, and outlive this.
  explicit PathBodies(const PathProblem& problem);

  std::size_t size() const { return bodies_.size(); }
  const BodyShape& operator[](std::uint32_t body) const { return bodies_[body]; }
  std::vector<BodyShape>::const_iterator begin() const { return bodies_.begin(); }
  std::vector<BodyShape>::const_iterator end() const { return bodies_.end(); }
  /// Does a joint move the body in the frame of its parent?
  bool moves(int body) const;
  /// Does a joint move it, or one of its parents?
  bool is_moved(const BodyShape& body) const;
  /// Two bodies that are not ignored, and that a joint moves against each other.
  bool is_tested(std::uint32_t a, std::uint32_t b) const;

 private:
  const PathProblem& problem_;
  std::vector<BodyShape> bodies_;
  IgnoredPairs ignored_;
};

}  // namespace taut::internal::proof
