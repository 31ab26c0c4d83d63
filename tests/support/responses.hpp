// What bodies do after a contact, for tests.
#pragma once

#include "support/rng.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {

/// A body without a parent goes on from where it is, moved by `shift`, with that velocity and spin about its own
/// origin.
Motion going_off(const Simulation& simulation, BodyId body, Point shift, Point velocity, double spin);

/// So far the two bodies of a contact are moved apart, which rounding never exceeds.
double small_gap(const Simulation& simulation);

/// The bodies of a contact part along the normal: one of them rests, or both move, or one is taken away or ignored.
void part(Simulation& simulation, const Contact& contact, Rng& rng);

/// Parts the bodies of all contacts that the simulation stands at.
void part_all(Simulation& simulation, Rng& rng);

}  // namespace taut::testing
