// A tree of oriented boxes over the edges of one polygon, in its own frame.
#pragma once

#include <vector>

#include "motion/pair_geometry.hpp"
#include "spacetime/stretch.hpp"

namespace taut::spacetime {

/// A rectangle: all centre + s along + t turned(along) with |s| <= half_length and |t| <= half_width.
struct Box {
  Vector centre, along;  ///< along is a unit vector up to rounding
  double half_length = 0, half_width = 0;
  double radius = 0;  ///< of a disc around the centre that contains the box
};

/// A run of consecutive edges. The box certainly contains all of them, as displaced.
struct BoxNode {
  Box box;
  std::uint32_t first = 0, count = 0;  ///< edges, by their first vertices, as indices of the pair
  std::uint32_t left = 0, right = 0;   ///< children; unused where count is 1
};

/// A balanced tree; the root is node 0.
class Hierarchy {
 public:
  /// Over the edges of P (`of_p`) or of Q.
  Hierarchy(const PairGeometry& geometry, bool of_p);
  const BoxNode& node(std::uint32_t i) const { return nodes_[i]; }
  std::size_t size() const { return nodes_.size(); }

 private:
  std::uint32_t build(const PairGeometry& geometry, std::uint32_t first, std::uint32_t count);

  std::vector<BoxNode> nodes_;
};

/// The box of the edges first, ..., first + count - 1, aligned with the chord of the run.
Box box_of_run(const PairGeometry& geometry, std::uint32_t first, std::uint32_t count);

}  // namespace taut::spacetime
