// Motions over long times: when their polynomials are taken about an instant of a segment, and from when on bodies
// that turn uniformly repeat their places.
#pragma once

#include "motion/piece_list.hpp"
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

// From when on two bodies are only where they have been before: bodies that turn uniformly repeat their places.

/// An instant before `end` from which on every place of one body, seen from the other, is one that it had since
/// `start`; infinite if none is known. What is shown of the time up to that instant holds to the end.
///
/// From the last joint on, all motions of both chains must rest or turn uniformly, about a pivot or in an orbit. Rates
/// are doubles, so all of them are multiples of their greatest common divisor u, and places repeat after a time of 2 pi
/// / u. The result is that much after the last joint, rounded up as docs/proof-format.md specifies: verifiers compute
/// the same.
double repeats_from(const MotionChain& p, const MotionChain& q, double start, double end);

}  // namespace taut::internal
