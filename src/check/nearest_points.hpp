// Two edges that are near each other, in the user's terms.
#pragma once

#include "search/pair_instance.hpp"
#include "taut/clearance.hpp"

namespace taut::internal {

/// The pair, the edges and their nearest points at that parameter of a segment; the points are world coordinates,
/// rounded. The distance and the time are left to the caller.
NearestPoints nearest_points_of(const PairInstance& search, std::size_t segment, double parameter, VertexId edge_p,
                                VertexId edge_q);

}  // namespace taut::internal
