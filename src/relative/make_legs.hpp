// From the motions of two bodies to the legs of their relative motion.
#pragma once

#include "relative/legs.hpp"

namespace taut {

/// The legs from start to end: one for each stretch without a joint, and a bridge at each joint where a piece changes.
inline Legs make_legs(const PieceList& p, const PieceList& q, double start, double end) {
  return Legs(MotionChain{p}, MotionChain{q}, start, end);
}
/// The same for bodies with parents.
inline Legs make_legs(const MotionChain& p, const MotionChain& q, double start, double end) {
  return Legs(p, q, start, end);
}

}  // namespace taut
