// From when on two bodies are only where they have been before: bodies that turn uniformly repeat their places.
#pragma once

#include "motion/piece_list.hpp"

namespace taut::internal {

/// An instant before `end` from which on every place of one body, seen from the other, is one that it had since
/// `start`; infinite if none is known. What is shown of the time up to that instant holds to the end.
///
/// From the last joint on, all motions of both chains must rest or turn uniformly, about a pivot or in an orbit. Rates
/// are doubles, so all of them are multiples of their greatest common divisor u, and places repeat after a time of 2 pi
/// / u. The result is that much after the last joint, rounded up as docs/proof-format.md specifies: verifiers compute
/// the same.
double repeats_from(const MotionChain& p, const MotionChain& q, double start, double end);

}  // namespace taut::internal
