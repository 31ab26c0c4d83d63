// All intervals in which two bodies overlap.
#pragma once

#include <vector>

#include "taut/intervals.hpp"
#include "world/world_plan.hpp"

namespace taut {

/// Between two crossings of an edge by a vertex that follow each other, the same edges cross, and whether the bodies
/// overlap does not change. So all crossings are found, put in order, and between any two the overlap is asked for, by
/// exact signs, at one instant. Throws Undecidable.
std::vector<OverlapInterval> overlap_intervals(const WorldPlan& plan, int a, int b, bool inwards);

}  // namespace taut
