// A quick separation test of two bodies in a window of time, before any model of their motion is made.
#pragma once

#include "spacetime/hierarchy.hpp"
#include "spacetime/uniform_motion.hpp"

namespace taut::internal::spacetime {

/// Boxes around moving bodies meet far more often than the bodies come near each other. Where both move uniformly, a
/// sine and a cosine make a stretch (UniformMotion), at a hundredth of the cost of a model over the window. A few
/// stretches show most of these pairs to be disjoint. True is a proof for all of [from, to] of the segment's parameter;
/// false has no meaning.
bool quickly_apart(const TreePair& trees, const MotionSegment& segment, double from, double to);

}  // namespace taut::internal::spacetime
