// The orientation of three displaced vertices of one body: it never changes, and is never zero in general position.
#pragma once

#include "geometry/displacement.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {

/// The sign of the orientation of (a, b, c): +1 if they turn left. 0 only if the displaced points are collinear.
/// Coordinates are at most 1 in magnitude, and no point is displaced by more than `room`.
int orientation(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                double room = displacement_room);
/// The same, if doubles decide, else 0. If they do, the points before the displacement turn that way, too, and c is
/// farther than 2^7 `room` from the line through a and b: the determinant is more than 2^9 `room`, and ab shorter
/// than 3.
int orientation_in_doubles(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                           double room = displacement_room);
/// The same as the first, and which stage decided.
StagedSign orientation_staged(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                              double room = displacement_room);

}  // namespace taut::internal
