// Convex polygons: a polygon with holes as a union of them, and what those with exact corners have in common.
#pragma once

#include <optional>
#include <vector>

#include "path/exact_point.hpp"
#include "taut/geometry.hpp"
#include "taut/outline.hpp"

namespace taut::internal::path {

/// Counterclockwise convex polygons whose interiors are disjoint and whose union is the part, exactly: by cutting off
/// ears, and joining what is convex together. Nothing if there are too many vertices, or it does not work out. The part
/// must be valid.
std::optional<std::vector<Polygon>> convex_pieces(const Part& part);

// What convex polygons with exact corners have in common.

/// The part of the ring to the left of the line from `a` to `b`, the line included. If it has no area: the point or the
/// two ends of the segment that it is if `flat`, else nothing.
ConvexRing left_of(const ConvexRing& ring, const ExactPoint& a, const ExactPoint& b, bool flat);

/// A point inside of the ring; if that has no area, a corner.
ExactPoint middle_of(const ConvexRing& ring);

/// A point inside of both polygons. Else, with `touching`, a corner of what they have in common, boundaries included.
/// Its coordinates are exact binary numbers, doubles where it can be. Nothing if there is none, or none is found.
std::optional<ExactPoint> common_point(const ConvexRing& a, const ConvexRing& b, bool touching);

}  // namespace taut::internal::path
