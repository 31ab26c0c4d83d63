// Convex hulls that rest on each other, and yet have nothing in common.
#pragma once

#include <vector>

#include "geometry/ids.hpp"

namespace taut::internal {

class Placement;

/// Boxes cannot decide bodies apart that rest on each other, and parts of both would be tiled anew. But of two convex
/// polygons that are disjoint, one has an edge with the other one beyond it, and doubles find those edges that may be
/// it: then exact orientations decide.
///
/// The hulls are given by their corners, with the body to the left. False if they are not disjoint, or if the few edges
/// that are tried do not show it.
bool hulls_apart(const Placement& placement, const std::vector<VertexId>& hull_p, const std::vector<VertexId>& hull_q);

}  // namespace taut::internal
