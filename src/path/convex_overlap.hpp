// What convex polygons with exact corners have in common.
#pragma once

#include <optional>

#include "path/exact_point.hpp"

namespace taut::internal::path {

/// The part of the ring to the left of the line from `a` to `b`; empty if there is none with an area.
ConvexRing left_of(const ConvexRing& ring, const ExactPoint& a, const ExactPoint& b);

/// A point inside of both polygons, whose coordinates are doubles. Else, with `touching`, a corner of one that is in
/// the other one, boundary included, if it has no weight. Nothing if there is none, or none is found.
std::optional<ExactPoint> common_point(const ConvexRing& a, const ConvexRing& b, bool touching);

}  // namespace taut::internal::path
