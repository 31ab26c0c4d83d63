// How far apart are two bodies at most, all over a stretch of time?
#pragma once

#include "spacetime/clearance.hpp"

namespace taut::internal::spacetime {

/// Not below the distance of the bodies at any time from `from` to `to` (from < to), in internal units. Any two points
/// of the bodies bound the distance: here a vertex and an edge that are nearest in the middle. So the bound gets close
/// as the stretch gets short.
double distance_bound(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments, double from,
                      double to, const ClearanceTolerance& tolerance);

}  // namespace taut::internal::spacetime
