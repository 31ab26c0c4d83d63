// Of bodies that only translate: at which displacements is the goal "outside" not reached?
#pragma once

#include "path/slides.hpp"

namespace taut::internal::path {

/// Open convex polygons of displacements as the map has them: at these, and of those in the joints' ranges no others,
/// the box of some body that moves and the box of some that does not have a common interior. Nothing if a body turns,
/// or moves in another way than the map says, other than by one of its joints.
std::optional<std::vector<ConvexRing>> boxes_overlap(const Linkage& linkage, const SlideMap& map,
                                                     const LinkedPairs& pairs);

}  // namespace taut::internal::path
