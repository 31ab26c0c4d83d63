// Two edges that are near each other, in the user's terms.
#pragma once

#include <string>

#include "solver/pair_solver.hpp"
#include "taut/clearance.hpp"

namespace taut::internal {

/// The pair, the edges and their nearest points at that parameter of a segment. The points are rounded world
/// coordinates. The caller sets the distance and the time.
NearestPoints nearest_points_of(const PairInstance& search, std::size_t segment, double parameter, VertexId edge_p,
                                VertexId edge_q);

/// Of a bracket of a distance: that coordinates are too large for this relative tolerance, which is why it is wider;
/// empty if it is not.
std::string why_wide(double lo, double hi, double relative);

}  // namespace taut::internal
