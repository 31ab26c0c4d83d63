// Does a displacement keep its laws?
#pragma once

#include <optional>
#include <vector>

#include "geometry/displacement.hpp"

namespace taut::internal {

/// Are all features of the polygon so large that no vertex that moves by less than `farthest` can break the laws of
/// displaced_polygon()? Coordinates are at most 1 in magnitude. Linear time; false is no proof of the contrary.
bool has_room(const std::vector<Point>& polygon, double farthest);

/// Two edges that come so close that the displaced ring meets itself or the ring it was made of, or lies on the wrong
/// side of it. Each corner must keep its own law, and no vertex move by `farthest` or more. Exact; about O(n log n).
std::optional<DisplacementFault> find_displacement_fault(const std::vector<DisplacedPoint>& ring, Offset offset,
                                                         double farthest);

}  // namespace taut::internal
