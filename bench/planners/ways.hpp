// Narrow passages: planners of OMPL with FCL, and find_path(), on the same problems.
#pragma once

namespace taut::bench {

/// Prints a table; `limit`: seconds of processor time for each run. False if find_path() was wrong about a problem, or
/// a way of it was not proved.
bool compare_ways(int runs, double limit);

}  // namespace taut::bench
