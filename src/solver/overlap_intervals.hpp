// All intervals in which two bodies overlap.
#pragma once

#include <vector>

#include "scene/instance.hpp"
#include "taut/intervals.hpp"

namespace taut::internal {

/// Between two consecutive crossings of an edge by a vertex, the same edges cross, and it does not change whether the
/// bodies overlap. So all crossings are found and ordered, and between any two the overlap is evaluated, by exact
/// signs, at one instant. `near` contains disjoint time intervals, in order, outside of which the bodies are certainly
/// disjoint. With `precisely`, every crossing is enclosed to within a few ulps before they are ordered, not only those
/// that end intervals or that rougher enclosures do not separate. If several occur at one instant, the one named by an
/// interval may depend on this. Throws Undecidable.
std::vector<OverlapInterval> overlap_intervals(const Instance& instance, int a, int b,
                                               const std::vector<TimeInterval>& near, Offset offset, bool precisely);

}  // namespace taut::internal
