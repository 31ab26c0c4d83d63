// From the motions of two bodies to the legs of their relative motion.
#pragma once

#include <vector>

#include "motion/pieces.hpp"
#include "relative/leg.hpp"

namespace taut {

/// The legs from start to end: one for each stretch without a joint, and a bridge at each joint where a piece changes.
std::vector<Leg> make_legs(const std::vector<MotionPiece>& p, const std::vector<MotionPiece>& q, double start,
                           double end);

/// The pieces of a body's motion after those of its parents, the outermost first.
using MotionChain = std::vector<std::vector<MotionPiece>>;
/// The same for bodies with parents.
std::vector<Leg> make_legs(const MotionChain& p, const MotionChain& q, double start, double end);

}  // namespace taut
