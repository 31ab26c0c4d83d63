// What convex polygons with exact corners have in common.
#pragma once

#include <optional>

#include "path/exact_point.hpp"

namespace taut::internal::path {

/// The part of the ring to the left of the line from `a` to `b`, the line included. If it has no area: the point or the
/// two ends of the segment that it is if `flat`, else nothing.
ConvexRing left_of(const ConvexRing& ring, const ExactPoint& a, const ExactPoint& b, bool flat);

/// A point inside of the ring; if that has no area, a corner.
ExactPoint middle_of(const ConvexRing& ring);

/// A point inside of both polygons. Else, with `touching`, a corner of what they have in common, boundaries included.
/// Its coordinates are exact binary numbers, doubles where it can be. Nothing if there is none, or none is found.
std::optional<ExactPoint> common_point(const ConvexRing& a, const ConvexRing& b, bool touching);

}  // namespace taut::internal::path
