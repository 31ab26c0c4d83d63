// Through which combinations of joint values could a way of some length lead?
#pragma once

#include "path/way.hpp"

namespace taut::internal::path {

/// A way from the start to the goal is at least as long as straight segments from the start to any of its combinations,
/// and from there to the goal. So those through which it leads are in an ellipsoid, if the goal is a point.
class Reach {
 public:
  Reach(const PathProblem& problem, const JointMetric& metric, double length)
      : problem_(problem), metric_(metric), length_(length) {}

  /// May a way that is no longer than the length lead through the cell?
  bool may_hold(const JointCell& cell) const;
  /// Of the cell, what is nearest to the middle between the start and the goal.
  JointValues middle_in(const JointCell& cell) const;
  /// Of the straight way, from below.
  double straight() const { return to_goal(ValueBox::of(problem_.start)); }

 private:
  double to_goal(const ValueBox& box) const;
  /// From one to the other, any periods on.
  double least(const ValueBox& a, const ValueBox& b) const;

  const PathProblem& problem_;
  const JointMetric& metric_;
  double length_;
};

}  // namespace taut::internal::path
