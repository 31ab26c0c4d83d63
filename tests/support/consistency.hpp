// Do the answers of all questions about one scene say the same?
#pragma once

#include <string>

#include "taut/check.hpp"

namespace taut::testing {

/// What contradicts what; empty if nothing does. The first contact of both engines, their proofs and verified logs, the
/// first interval's beginning and the end of the range from the start are one instant, which each bracket holds; the
/// clearance is 0 if and only if bodies touch or overlap; a margin is kept if and only if the clearance is not less.
std::string inconsistency(const Scene& scene, Touch touch, double max_seconds);

}  // namespace taut::testing
