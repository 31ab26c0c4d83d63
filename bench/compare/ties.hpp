// What ties cost: scenes drawn on a grid, where many events fall on one instant, beside the same scenes with every
// coordinate moved a little.
#pragma once

namespace taut::bench {

/// Prints a table; each row takes about so many seconds. False if an answer is wrong.
bool compare_ties(double seconds);

}  // namespace taut::bench
