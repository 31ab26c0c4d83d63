// Has the displacement made a polygon cross itself?
#pragma once

#include <optional>
#include <utility>

#include "motion/pair_geometry.hpp"

namespace taut {

/// Two edges of one displaced polygon that cross, because the polygon has features finer than the displacement; by
/// their first vertices. Only where PairGeometry::fine_features is set can there be any. Exact; about O(n log n).
std::optional<std::pair<VertexId, VertexId>> crossing_within_body(const PairGeometry& geometry);

}  // namespace taut
