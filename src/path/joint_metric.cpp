#include "path/joint_metric.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::path {

JointMetric::JointMetric(const PathProblem& problem, const JointSpace& space) : dimension_(space.dimension()) {
  const LinkedPairs& pairs = space.pairs();
  JointCell around{problem.start, {}};
  for (std::size_t k = 0; k < dimension_; ++k) {
    const Joint& joint = problem.linkage.joints[k];
    // The rates of a small cell are the derivatives at its middle, times this.
    around.half[k] = (joint.hi - joint.lo) * 0x1p-20;
    // Values are rounded where cells are halved, and where a period is added.
    rounding_[k] = 0x1p-46 * (std::fabs(joint.lo) + std::fabs(joint.hi));
  }
  const int n = static_cast<int>(problem.linkage.scene.bodies.size());
  for (int body = 0; body < n; ++body) {
    if (!pairs.moves(body)) continue;
    const PoseModel pose = pairs.pose(body, around);
    for (const int section : pairs.world().sections(body)) {
      const RingSet& rings = *pairs.world().bodies()[static_cast<std::size_t>(section)].rings;
      for (std::size_t ring = 0; ring < rings.rings().size(); ++ring) {
        for (const Point& p : rings.points(ring)) {
          const JointModel place = pose.place({p.x, p.y});
          for (std::size_t k = 0; k < dimension_; ++k) {
            if (!(around.half[k] > 0)) continue;
            const Vector& r = place.rate[k];
            weights_[k] = std::max(weights_[k], std::sqrt(dot(r, r)) / around.half[k] / pairs.scale());
          }
        }
      }
    }
  }
}

double JointMetric::length(const JointValues& a, const JointValues& b) const {
  double sum = 0;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double d = weights_[k] * (b[k] - a[k]);
    sum += d * d;
  }
  return std::sqrt(sum) * (1 + 0x1p-40);
}

double JointMetric::length(const std::vector<JointValues>& way) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) sum += length(way[i], way[i + 1]);
  return sum * (1 + 0x1p-40);
}

double JointMetric::least(const ValueBox& a, const ValueBox& b) const {
  double sum = 0;
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double gap = std::max(b.lo[k] - a.hi[k], a.lo[k] - b.hi[k]) - rounding_[k];
    if (!(gap > 0)) continue;
    const double d = weights_[k] * gap;
    sum += d * d;
  }
  return std::sqrt(sum) * (1 - 0x1p-40);
}

}  // namespace taut::internal::path
