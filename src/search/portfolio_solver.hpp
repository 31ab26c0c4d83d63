// Who answers for the pairs of a world?
#pragma once

#include <memory>

#include "search/kinetic_solver.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// The two bodies with that engine, with both, or with both in turn. What is given must outlive it.
std::unique_ptr<PairSolver> windowed_pair(EngineChoice engine, const WorldPlan& world, int a, int b, bool inwards,
                                          EventBudget& budget);

/// The two bodies with both engines in turn, for each window anew. Tilings of all parts take long to build: so much
/// work by boxes is worth trying before.
std::unique_ptr<PairSolver> pair_in_turns(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget,
                                          std::uint64_t first_turn = 8192);

}  // namespace taut::internal
