// A first look at two bodies in a window of time, before any model of their motion is made.
#pragma once

#include "spacetime/hierarchy.hpp"
#include "spacetime/uniform_motion.hpp"

namespace taut::internal::spacetime {

/// Boxes around moving bodies meet far more often than the bodies come near each other. Where both move evenly, a sine
/// and a cosine make a stretch (UniformMotion), a hundredth of what a model over the window costs; a few of them show
/// most of these pairs to be apart. True is a proof for all of [from, to] of the segment's parameter; false says
/// nothing.
bool quickly_apart(const TreePair& trees, const MotionSegment& segment, double from, double to);

}  // namespace taut::internal::spacetime
