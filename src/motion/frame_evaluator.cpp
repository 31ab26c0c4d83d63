#include "motion/frame_sample.hpp"

#include <algorithm>

namespace taut::internal {

FrameEvaluator::FrameEvaluator(const MotionSegment& segment) {
  const double length = segment.end - segment.start;
  looks_ = {frame_values(segment, Ball<double>::exact(segment.start + 0.3127 * length)),
            frame_values(segment, Ball<double>::exact(segment.start + 0.7841 * length))};
}

bool FrameEvaluator::differs_from_zero(bool pp, const std::array<Ball<double>, 5>& c) const {
  return std::any_of(looks_.begin(), looks_.end(), [&](const FrameValues<double>& look) {
    const std::array<Ball<double>, 5>& f = pp ? look.for_pp : look.for_qq;
    Ball<double> sum = f[0] * c[0];
    for (std::size_t i = 1; i < c.size(); ++i) sum = sum + f[i] * c[i];
    return sum.sign() != 0;
  });
}

}  // namespace taut::internal
