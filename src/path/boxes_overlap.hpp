// Of bodies that only translate: at which displacements is the goal "outside" not reached?
#pragma once

#include <array>

#include "path/slides.hpp"

namespace taut::internal::path {

/// The displacements at which the boxes of a body that moves and of one that does not have a common interior: an open
/// convex polygon.
struct BoxesOverlap {
  ConvexRing ring;
  std::array<BodyId, 2> bodies;    ///< the one that moves first
  bool moves_like_the_map = true;  ///< else it moves by one of its joints only
};

/// As the map has displacements, and of all those in the joints' ranges. Nothing if a body turns, or moves in another
/// way than the map says, other than by one of its joints.
std::optional<std::vector<BoxesOverlap>> boxes_overlap(const Linkage& linkage, const SlideMap& map,
                                                       const LinkedPairs& pairs);

}  // namespace taut::internal::path
