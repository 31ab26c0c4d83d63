// Converts the motions of two bodies to the segments of their relative motion.
#pragma once

#include "motion/motion_segments.hpp"

namespace taut::internal {

/// The segments from start to end: one for each interval without a joint, and a bridge at each joint where a piece
/// changes.
inline MotionSegments make_segments(const PieceList& p, const PieceList& q, double start, double end) {
  return MotionSegments(MotionChain{p}, MotionChain{q}, start, end);
}
/// The segments for bodies with parents.
inline MotionSegments make_segments(const MotionChain& p, const MotionChain& q, double start, double end) {
  return MotionSegments(p, q, start, end);
}

}  // namespace taut::internal
