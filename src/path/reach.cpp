#include "path/reach.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::path {

bool Reach::may_hold(const JointCell& cell) const {
  ValueBox box;
  for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
    box.lo[k] = cell.middle[k] - cell.half[k];
    box.hi[k] = cell.middle[k] + cell.half[k];
  }
  return least(ValueBox::of(problem_.start), box) + to_goal(box) <= length_;
}

/// Periods do not count: it is only where a way may be short.
JointValues Reach::middle_in(const JointCell& cell) const {
  JointValues point = cell.middle;
  for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
    const Joint& joint = problem_.linkage.joints[k];
    const double start = problem_.start[k];
    const auto& goal = problem_.goal[k];
    const double middle = goal ? (start + std::clamp(start, (*goal)[0], (*goal)[1])) / 2 : start;
    point[k] = std::clamp(std::clamp(middle, cell.middle[k] - cell.half[k], cell.middle[k] + cell.half[k]), joint.lo,
                          joint.hi);
  }
  return point;
}

/// Of a goal outside, nothing is known.
double Reach::to_goal(const ValueBox& box) const {
  if (problem_.goal_outside) return 0;
  ValueBox goal = box;
  for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
    if (!problem_.goal[k]) continue;
    goal.lo[k] = (*problem_.goal[k])[0];
    goal.hi[k] = (*problem_.goal[k])[1];
  }
  return least(box, goal);
}

double Reach::least(const ValueBox& a, const ValueBox& b) const {
  JointValues gap{};
  for (std::size_t k = 0; k < problem_.linkage.joints.size(); ++k) {
    const Joint& joint = problem_.linkage.joints[k];
    const double period = problem_.periodic[k] ? joint.hi - joint.lo : 0;
    gap[k] = INFINITY;
    for (const double shift : {0.0, period, -period})
      gap[k] = std::min(gap[k], std::max({b.lo[k] + shift - a.hi[k], a.lo[k] - b.hi[k] - shift, 0.0}));
  }
  return metric_.least(ValueBox::of({}), ValueBox::of(gap));
}

}  // namespace taut::internal::path
