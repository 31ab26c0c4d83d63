// All intervals in which two bodies overlap.
#pragma once

#include <vector>

#include "taut/intervals.hpp"
#include "world/world_plan.hpp"

namespace taut::internal {

/// Between two crossings of an edge by a vertex that follow each other, the same edges cross, and whether the bodies
/// overlap does not change. So all crossings are found, put in order, and between any two the overlap is asked for, by
/// exact signs, at one instant. `near` are the stretches of time, in order and apart, outside of which the bodies are
/// certainly apart. `precisely`: every crossing is enclosed within a few ulps before they are put in order, and not
/// only those that end intervals or that rougher enclosures do not tell apart; which of several at one instant an
/// interval names may depend on it. Throws Undecidable.
std::vector<OverlapInterval> overlap_intervals(const WorldPlan& plan, int a, int b,
                                               const std::vector<TimeInterval>& near, bool inwards, bool precisely);

}  // namespace taut::internal
