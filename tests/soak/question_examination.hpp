// One scene of two bodies for the soak of questions: all that can be asked about it, held against each other.
#pragma once

#include <string>

#include "soak_scene.hpp"
#include "soak_totals.hpp"

namespace taut::testing {

/// What is wrong with the answers about a scene; empty if nothing is. The laws:
///   1. the first interval begins at the first contact; there is none if and only if check() says free;
///   2. a range ends where intervals do;
///   3. c* > 0 if and only if closed checking is free;
///   4. a margin is kept if and only if it is not greater than c*;
///   5. no distance over time is less than c*, and one is not greater;
///   6. at an instant within an interval the bodies as they stand are not apart; at one in none, shrunk bodies are;
///   7. a direction is free if and only if moving that way is;
///   8. time reversed exchanges enter and exit.
std::string examine_questions(const SoakScene& s, std::uint64_t number, double max_seconds, Tally& tally);

}  // namespace taut::testing
