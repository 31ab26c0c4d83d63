// The complete sequence of contacts of a follower with what is below it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "query/lift_functions.hpp"
#include "taut/follow.hpp"

namespace taut::internal {

/// In [start, end] of the scene, the follower is proved free at `reach`. Lengths are the scene's.
struct SequenceQuestion {
  BodyId follower;
  Point direction;  ///< of any length but 0
  double reach;
  double shortest;  ///< how short a stretch is left open
  Touch touch;
};

/// The stretches of the scene's time, in order, without a gap. Time is halved until one pair of features is certainly
/// above all others, or the rest is short enough. The scene must be valid, without curves.
///
/// Where a limit comes first, the rest of the time is one open stretch. `reason` says why the first open stretch is.
std::vector<FollowStretch> contact_sequence(const Instance& instance, const SequenceQuestion& question,
                                            std::string& reason);

}  // namespace taut::internal
