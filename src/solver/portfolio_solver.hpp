// Chooses the engines for the pairs of a world.
#pragma once

#include <memory>

#include "solver/kinetic_solver.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// Which engines solve a pair, and who watches.
struct SolverChoice {
  EngineChoice engine = EngineChoice::usual;
  /// Of `either`: the work of the first engine before the other one begins. Tilings of all parts take long to build.
  std::uint64_t first_slice = 8192;
  EngineName first = EngineName::spacetime;
  KineticObserver* observer = nullptr;  ///< of the kinetic engine's events; may be null
};

/// The two bodies with the given engine, with both, or with both in alternating slices, which start again in each
/// window. The arguments must outlive the solver.
std::unique_ptr<PairSolver> pair_solver(const SolverChoice& choice, const Instance& world, int a, int b, Offset offset,
                                        EventBudget& budget);

}  // namespace taut::internal
