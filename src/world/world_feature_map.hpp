// Two bodies of a world that overlap: a point that shows it.
#pragma once

#include "world/world_plan.hpp"

namespace taut::internal {

/// As common_point() of a pair (src/pair/overlap_witness.hpp), at the world's start.
std::optional<Point> common_point(const WorldPlan& world, int a, int b);

}  // namespace taut::internal
