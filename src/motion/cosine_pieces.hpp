// A rotation given by its cosine, cut where the cosine reaches 1 or -1.
#pragma once

#include <vector>

#include "taut/motion.hpp"

namespace taut::internal {

/// The piece as one or more that together are the same motion on [from, to]. Where the cosine reaches 1 or -1 inside,
/// at an instant that is a double, the sine has a kink or the angle infinite speed: there one piece ends and the next
/// one begins, so that such an instant is an end of a segment. Where the cosine is beyond 1 in magnitude, by rounding
/// of its coefficients, and where it is 1 or -1 all the time, the body rests, not turned or by half a turn. Where it
/// touches 1 or -1 between two doubles, the body rests so between the neighbours of these: the turn that this leaves
/// out is of the order of 2^-50. Other pieces stay as they are.
std::vector<MotionPiece> cut_at_extremes(const MotionPiece& piece, double from, double to);

}  // namespace taut::internal
