// The moving scenes that are measured, each with the answer it must get.
#pragma once

#include <vector>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::bench {

struct Case {
  Scene scene;
  Outcome outcome = Outcome::free;
  double contact_time = 0;  ///< if the outcome is `contact`: from brute force
};

struct Family {
  const char* name;
  /// About n vertices per polygon (dips: the disc; the cup has 8).
  Case (*make)(int n);
};

/// gears: one full turn, teeth n/8 and n/8 + 1. gears_equal: the same with equal gears, so that many events coincide.
/// combs: sliding within the slots. combs_out: pulled out in a straight line. dips: 8 dips on one polynomial path.
/// dips_linear: the same dips straight down and up, in 16 pieces. far: an island hits another one, coming from 500
/// diameters away.
const std::vector<Family>& families();

/// Combs interlocked and at rest, from time 0 to `end`.
Scene resting_combs(int n, double end);

/// Two equal wheels with square teeth, the teeth of one in the middle of the other's gaps, one turn in opposite
/// directions.
Scene square_gears(int n);

}  // namespace taut::bench
