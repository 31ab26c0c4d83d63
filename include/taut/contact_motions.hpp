// Motions that are often wanted at a contact: a body stops, or gives way to what pushes it. For a follower on a cam see
// taut/follow.hpp.
//
// None of these assumes a law of forces, and between two contacts all motions are exact. A body that stops or gives way
// is first moved off the contact, along its normal, by a gap that covers the rounding of its new motion.
#pragma once

#include <optional>

#include "taut/simulation.hpp"

namespace taut {

/// A gap that covers rounding: 2^-44 of the largest coordinate in the scene.
double small_gap(const Simulation& simulation);

/// At a contact, one of its bodies stops where it is. `gap`: 0 stands for small_gap(). Goes on with resume(). Throws
/// InputError unless the simulation stands at a contact of that body.
void stop(Simulation& simulation, BodyId body, double gap = 0);

/// How a body can give way: it turns about a hinge, or slides. Places and directions are those of the frame in which
/// its motion is seen: the world's, for a body without a parent.
struct Guide {
  std::optional<Point> hinge;
  Point direction = {};  ///< without a hinge; any length
};

/// At a contact, the other body pushes this one along its guide: it moves evenly for the time `step`, a little faster
/// than the other one comes (by a sixteenth, along the normal), and then rests. When the other body has caught up,
/// there is the next contact. So a door that is pushed open touches the opener at every contact, and in between is
/// ahead of it by no more than what it turns in a step. Assumes friction enough to stop what is not pushed. A body that
/// is not pushed, since the two part, goes on. Goes on with resume(). Throws InputError as stop() does, and where the
/// guide does not lead away from the contact.
void push(Simulation& simulation, BodyId body, const Guide& guide, double step, double gap = 0);

}  // namespace taut
