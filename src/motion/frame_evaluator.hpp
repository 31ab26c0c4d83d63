// The frame functions at two instants: most combinations of them differ from zero there already.
#pragma once

#include <array>

#include "motion/motion_segment.hpp"

namespace taut::internal {

/// An evaluation at these two instants costs very little compared to the frame's identities (FrameIdentities), which
/// few certificate functions need.
class FrameEvaluator {
 public:
  explicit FrameEvaluator(const MotionSegment& segment);
  /// Is the sum of these coefficients times the frame functions for `pp` certainly not identically zero on the segment?
  bool differs_from_zero(bool pp, const std::array<Ball<double>, 5>& coefficients) const;

 private:
  std::array<FrameValues<double>, 2> looks_;
};

}  // namespace taut::internal
