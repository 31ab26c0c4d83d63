#include "path/goal.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::path {

/// The values of the joint that are the goal and in the box, perhaps some periods on; nothing if there are none.
std::optional<std::array<double, 2>> Goal::values_in(const JointCell& box, std::size_t joint) const {
  const double lo = box.middle[joint] - box.half[joint], hi = box.middle[joint] + box.half[joint];
  const auto& goal = problem_.goal[joint];
  if (!goal) return std::array<double, 2>{lo, hi};
  const Joint& range = problem_.linkage.joints[joint];
  const double period = problem_.periodic[joint] ? range.hi - range.lo : 0;
  for (const double turn : {0.0, period, -period}) {
    const double from = std::max(lo, (*goal)[0] + turn), to = std::min(hi, (*goal)[1] + turn);
    if (from <= to) return std::array<double, 2>{from, to};
  }
  return std::nullopt;
}

bool Goal::may_meet(const JointCell& box) const {
  if (problem_.goal_outside) return outside(box) >= 0;
  for (std::size_t k = 0; k < space_.dimension(); ++k) {
    if (!values_in(box, k)) return false;
  }
  return true;
}

std::optional<JointValues> Goal::point_in(const JointCell& box) const {
  if (problem_.goal_outside) {
    if (outside({box.middle, {}}) > 0) return box.middle;
    return std::nullopt;
  }
  JointValues point{};
  for (std::size_t k = 0; k < space_.dimension(); ++k) {
    const auto values = values_in(box, k);
    if (!values) return std::nullopt;
    const Joint& joint = problem_.linkage.joints[k];
    point[k] = std::clamp(box.middle[k], (*values)[0], (*values)[1]);
    if (!problem_.periodic[k]) point[k] = std::clamp(point[k], joint.lo, joint.hi);
  }
  return point;
}

std::optional<JointValues> Goal::only() const {
  if (problem_.goal_outside) return std::nullopt;
  JointValues only{};
  for (std::size_t k = 0; k < space_.dimension(); ++k) {
    const auto& goal = problem_.goal[k];
    if (!goal || (*goal)[0] != (*goal)[1]) return std::nullopt;
    only[k] = (*goal)[0];
  }
  return only;
}

Goal::BodyExtents Goal::extents(int body, const JointCell& box) const {
  const PoseModel pose = space_.pairs().pose(body, box);
  constexpr double far = INFINITY;
  BodyExtents found{{far, -far, far, -far}, {far, -far, far, -far}};
  // The box of a body is as far to each side as its farthest vertex: of all values, the least and the largest.
  for (const int section : space_.pairs().world().sections(body)) {
    const RingSet& rings = *space_.pairs().world().bodies()[static_cast<std::size_t>(section)].rings;
    for (std::size_t ring = 0; ring < rings.rings().size(); ++ring) {
      for (const Point& p : rings.points(ring)) {
        const JointModel z = pose.place({p.x, p.y});
        const double error = z.error + 0x1p-45 * (1 + z.reach());
        double dx = error, dy = error;
        for (const Vector& r : z.rate) {
          dx += std::fabs(r.x);
          dy += std::fabs(r.y);
        }
        Extent &a = found.least, &b = found.most;
        a = {std::min(a.lo_x, z.value.x + dx), std::max(a.hi_x, z.value.x - dx), std::min(a.lo_y, z.value.y + dy),
             std::max(a.hi_y, z.value.y - dy)};
        b = {std::min(b.lo_x, z.value.x - dx), std::max(b.hi_x, z.value.x + dx), std::min(b.lo_y, z.value.y - dy),
             std::max(b.hi_y, z.value.y + dy)};
      }
    }
  }
  return found;
}

int Goal::outside(const JointCell& box) const {
  const int n = static_cast<int>(problem_.linkage.scene.bodies.size());
  std::vector<BodyExtents> moving, resting;
  for (int body = 0; body < n; ++body) (space_.pairs().moves(body) ? moving : resting).push_back(extents(body, box));
  const auto apart = [](const Extent& a, const Extent& b) {
    return a.lo_x >= b.hi_x || b.lo_x >= a.hi_x || a.lo_y >= b.hi_y || b.lo_y >= a.hi_y;
  };
  bool all = true;
  for (const BodyExtents& a : moving) {
    for (const BodyExtents& b : resting) {
      all = all && apart(a.most, b.most);
      // What each certainly covers has an interior in common: for all values they overlap.
      const auto overlap = [](double lo_a, double hi_a, double lo_b, double hi_b) {
        return std::max(lo_a, lo_b) < std::min(hi_a, hi_b);
      };
      if (overlap(a.least.lo_x, a.least.hi_x, b.least.lo_x, b.least.hi_x) &&
          overlap(a.least.lo_y, a.least.hi_y, b.least.lo_y, b.least.hi_y))
        return -1;
    }
  }
  return all ? 1 : 0;
}

}  // namespace taut::internal::path
