// How long ways between joint values are.
#pragma once

#include "path/joint_space.hpp"

namespace taut::internal::path {

/// A box of joint values.
struct ValueBox {
  JointValues lo{}, hi{};

  static ValueBox of(const JointValues& point) { return {point, point}; }
};

/// The square root of the sum of (weight times difference)^2 over all joints. A joint's weight is the speed of the
/// fastest vertex of any body at the start, if that joint alone moves at speed 1.
class JointMetric {
 public:
  JointMetric(const PathProblem& problem, const JointSpace& space);

  const JointValues& weights() const { return weights_; }
  /// The length of a straight segment, rounded up.
  double length(const JointValues& a, const JointValues& b) const;
  double length(const std::vector<JointValues>& way) const;
  /// Bounds the length of any segment between two boxes from below, though the boxes be rounded to doubles.
  double least(const ValueBox& a, const ValueBox& b) const;

 private:
  JointValues weights_{}, rounding_{};
  std::size_t dimension_;
};

}  // namespace taut::internal::path
