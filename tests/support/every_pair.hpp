// An answer about all pairs lists those that were examined; tests want the others, too.
#pragma once

#include <vector>

#include "taut/check.hpp"

namespace taut::testing {

/// Of an answer with CheckOptions::all_pairs, in the order of the scene: every pair that is asked about. Those that are
/// not in the answer are free.
std::vector<PairAnswer> every_pair(const Scene& scene, const Answer& answer);

}  // namespace taut::testing
