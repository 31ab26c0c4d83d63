// Two edges that are near each other, in the user's terms.
#pragma once

#include "search/pair_search.hpp"
#include "taut/clearance.hpp"

namespace taut {

/// The pair, the edges and their nearest points at that parameter of a leg; the points are world coordinates, rounded.
/// The distance and the time are left to the caller.
NearestPoints nearest_points_of(const PairSearch& search, std::size_t leg, double parameter, VertexId edge_p,
                                VertexId edge_q);

}  // namespace taut
