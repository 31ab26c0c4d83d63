// The orientation of three displaced vertices of one body: it never changes, and is never zero in general position.
#pragma once

#include "geometry/displacement.hpp"
#include "numeric/stages.hpp"

namespace taut {

/// The sign of the orientation of (a, b, c): +1 if they turn left. 0 only if the displaced points are collinear.
int orientation(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c);
/// The same, and which stage told.
StagedSign orientation_staged(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c);

}  // namespace taut
