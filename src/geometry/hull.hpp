// Convex hulls, the orientation of a polygon, its diameter.
//
// All points must satisfy the range of predicates.hpp.
#pragma once

#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {

/// The vertices of the convex hull, as indices into `points`: counterclockwise, strictly convex, beginning with the
/// lexicographically smallest point. Exact, O(n log n). Of equal points the lowest index is named. Points on a line
/// give its two ends, equal points one index, no points none.
std::vector<int> convex_hull(const std::vector<Point>& points);

/// The sign of the area of a simple polygon, exact: +1 if its vertices run counterclockwise, -1 if clockwise. O(n).
int polygon_orientation(const Polygon& polygon);

/// The square of the largest distance between two of the points, by rotating calipers: the pairs compared are chosen
/// exactly, their distances are rounded (relative error below 2^-50). 0 for fewer than two points.
double diameter_squared(const std::vector<Point>& points);

}  // namespace taut::internal
