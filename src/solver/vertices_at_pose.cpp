#include "solver/free_directions.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal {

VerticesAtPose::VerticesAtPose(const InstanceBody& body, double t, Offset offset)
    : polygon_(body.rings->displaced(offset)), chain_(pieces_at(body.motions, t)), t_(t) {
  turned_ = turns(chain_);
  const Pose<double> pose = pose_of<Jet<double>>(chain_, Ball<double>::exact(t));
  origin_ = {pose.ox.v.mid, pose.oy.v.mid};
  axis_ = {pose.xx.v.mid, pose.xy.v.mid};
  double largest = 0;
  positions_.reserve(polygon_->points.size());
  for (const DisplacedPoint& p : polygon_->points) {
    largest = std::max(largest, std::fabs(p.x) + std::fabs(p.y));
    positions_.push_back(place({p.x, p.y}));
  }
  const double shift = pose.ox.v.rad + pose.oy.v.rad, rotation = pose.xx.v.rad + pose.xy.v.rad;
  error_ = shift + rotation * largest + 0x1p-48 * (l1_norm(origin_) + 2 * largest) + displacement_room;
}

Vector VerticesAtPose::place(Vector v) const { return origin_ + axis_ * v; }

template <class Real>
std::array<Ball<Real>, 2> VerticesAtPose::enclosed(std::uint32_t k) const {
  using B = Ball<Real>;
  const DisplacedPoint& p = polygon_->points[k];
  const B x = B::exact(p.x) + B::exact(p.dx), y = B::exact(p.y) + B::exact(p.dy);
  std::optional<Pose<Real>>& known = std::get<std::optional<Pose<Real>>>(poses_);
  if (!known) known = pose_of<Jet<Real>>(chain_, B::exact(t_));
  const Pose<Real>& pose = *known;
  if (!turned_) return {pose.ox.v + x, pose.oy.v + y};
  return {pose.ox.v + pose.xx.v * x - pose.xy.v * y, pose.oy.v + pose.xy.v * x + pose.xx.v * y};
}

#define TAUT_ENCLOSED(Real) template std::array<Ball<Real>, 2> VerticesAtPose::enclosed(std::uint32_t) const;
TAUT_FOR_EACH_PRECISION(TAUT_ENCLOSED)
TAUT_ENCLOSED(double)
#undef TAUT_ENCLOSED

}  // namespace taut::internal
