// From when on the polynomials of pieces are taken about an instant of a segment.
#pragma once

#include "motion/pose.hpp"

namespace taut::internal {

/// The highest power of the time in a motion, and 1 at least.
int highest_power(const MotionPiece& piece);

/// Do the terms of polynomials with this power cancel over [start, end] by so much that it matters? Where an interval
/// is L of its lengths from time 0, they do by L^power, and of the 53 bits of doubles up to 18 are left to that: to
/// make polynomials anew costs each segment some microseconds, which keyframes by the hundred thousand need not spend.
bool is_far_for(int power, double start, double end);
/// Do they, for the polynomials of a piece, or of any piece of a chain, in powers of the time since its origin?
bool is_far_for(const MotionPiece& piece, double start, double end);
bool is_far_for(const PieceChain& chain, double start, double end);

}  // namespace taut::internal
