// Chooses the engines for the pairs of a world.
#pragma once

#include <memory>

#include "search/kinetic_solver.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// The two bodies with the given engine, with both, or with both in alternating slices. The arguments must outlive the
/// solver.
std::unique_ptr<PairSolver> windowed_pair(EngineChoice engine, const WorldPlan& world, int a, int b, bool inwards,
                                          EventBudget& budget);

/// The two bodies with both engines in alternating slices, starting again in each window. Tilings of all parts take
/// long to build, so this much work by boxes is tried first.
std::unique_ptr<PairSolver> pair_in_turns(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget,
                                          std::uint64_t first_turn = 8192);

}  // namespace taut::internal
