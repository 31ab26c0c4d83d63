// Simulations of worlds held against answers about them, and changes of plan for them.
#pragma once

#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {

/// By the second engine.
Answer fresh_answer(const Scene& scene, Touch touch);
/// The same about the rest of the simulation's scene, from the present on.
Answer asked_afresh(const Simulation& simulation, Touch touch);

struct SimulationCounts {
  int contacts = 0, finished = 0, overlaps = 0, changes = 0;
};

/// The simulation is where the answer says that the scene comes to.
void expect_ended(const Simulation& simulation, const Answer& answer, SimulationCounts& counts);

/// On from where the body is at that time, seen from its parent: evenly, in another direction, or it stays.
Motion going_on(const Body& body, double t, Rng& rng);

}  // namespace taut::testing
