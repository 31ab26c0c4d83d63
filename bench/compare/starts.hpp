// A start near the last one beside a new start.
#pragma once

namespace taut::bench {

/// Prints a table; each row takes about so many seconds. False if an answer is wrong.
bool compare_starts(double seconds);

}  // namespace taut::bench
