// One world of the soak: everything that is asked about worlds, held against the definition and against each other.
#pragma once

#include <string>

#include "soak_totals.hpp"
#include "support/small_world.hpp"

namespace taut::testing {

/// What is wrong with the answers about world `number`; empty if nothing is. Each world counts once as a scene, and
/// with both touch modes' outcomes.
std::string examine_world(std::uint64_t number, const LargeWorld& made, double max_seconds, Tally& tally);

}  // namespace taut::testing
