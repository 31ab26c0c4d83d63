// A first look at two bodies in a window of time, before any model of their motion is made.
#pragma once

#include "spacetime/even_motion.hpp"
#include "spacetime/hierarchy.hpp"

namespace taut::spacetime {

/// Boxes around moving bodies meet far more often than the bodies come near each other. Where both move evenly, a sine
/// and a cosine make a stretch (EvenMotion), a hundredth of what a model over the window costs; a few of them show most
/// of these pairs to be apart. True is a proof for all of [from, to] of the leg's parameter; false says nothing.
bool apart_at_a_glance(const TreePair& trees, const Leg& leg, double from, double to);

}  // namespace taut::spacetime
