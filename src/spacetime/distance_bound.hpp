// An upper bound of the distance of two bodies throughout a stretch of time.
#pragma once

#include "spacetime/clearance.hpp"

namespace taut::internal::spacetime {

/// An upper bound of the bodies' distance at all times from `from` to `to` (from < to), in internal units. Any two
/// points of the bodies bound the distance. Here they belong to a vertex and an edge that are nearest in the middle, so
/// the bound becomes tight as the stretch becomes short.
double distance_bound(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments, double from,
                      double to, const ClearanceTolerance& tolerance);

}  // namespace taut::internal::spacetime
