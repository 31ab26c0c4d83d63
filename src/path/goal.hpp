// Which combinations of joint values are the goal?
#pragma once

#include <optional>

#include "path/cell_tree.hpp"

namespace taut::internal::path {

class Goal {
 public:
  Goal(const PathProblem& problem, const JointSpace& space) : problem_(problem), space_(space) {}

  /// May some of these combinations be the goal?
  bool may_meet(const JointCell& box) const;
  /// One of these combinations that certainly is: the nearest one to its middle. Nothing if none was found.
  std::optional<JointValues> point_in(const JointCell& box) const;
  /// The only combination that is the goal, if there is no more than one.
  std::optional<JointValues> only() const;

 private:
  struct Extent {
    double lo_x, hi_x, lo_y, hi_y;
  };
  struct BodyExtents {
    Extent least, most;  ///< what its box certainly covers, and what it stays in
  };
  BodyExtents extents(int body, const JointCell& box) const;
  /// 1: the boxes of what moves and what does not are apart for all values, -1: for none, 0: not known.
  int outside(const JointCell& box) const;
  std::optional<std::array<double, 2>> values_in(const JointCell& box, std::size_t joint) const;

  const PathProblem& problem_;
  const JointSpace& space_;
};

}  // namespace taut::internal::path
