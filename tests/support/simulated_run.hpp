// Random simulations that go on after contacts, with all calls there are, held against the other engine.
#pragma once

#include <cstdint>
#include <string>

#include "taut/scene.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {

struct RunTally {
  int contacts = 0, again = 0, several = 0, calls = 0, refused = 0, ends = 0, scenes = 0;
};

/// Run `number`, of so many calls at most. Every next contact is compared with what the rest of the scene, asked
/// afresh, comes to, and all that was recorded must be free. Returns what is wrong; empty if nothing is.
std::string wrong_with_run(std::uint64_t number, const Scene& scene, Touch touch, int calls, RunTally& tally);

}  // namespace taut::testing
