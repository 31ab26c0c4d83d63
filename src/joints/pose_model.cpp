#include "joints/pose_model.hpp"

#include <cmath>

#include "motion/joint_functions.hpp"
#include "motion/joint_value.hpp"
#include "motion/loop_region.hpp"
#include "numeric/trig.hpp"

namespace taut::internal {
namespace {

/// More than the rounding of the few operations on bounds.
constexpr double up = 1 + 0x1p-40;
/// More than what rounds in a product or a sum, as a share of the magnitudes.
constexpr double rounding_share = 0x1p-48;

double magnitude(Vector v) { return std::sqrt(dot(v, v)) * up; }

/// How far the linear part leads from the middle's value, at most.
double linear_swing(const JointModel& a) {
  double sum = 0;
  for (const Vector& r : a.rate) {
    if (r.x != 0 || r.y != 0) sum += magnitude(r);
  }
  return sum * up;
}

/// No less than all magnitudes, without a root: what rounds is small.
double rough_reach(const JointModel& a) {
  double sum = l1_norm(a.value) + a.error;
  for (const Vector& r : a.rate) sum += l1_norm(r);
  return sum * up;
}

}  // namespace

double JointModel::swing() const { return (linear_swing(*this) + error) * up; }

double JointModel::reach() const { return (magnitude(value) + swing()) * up; }

JointModel operator+(const JointModel& a, const JointModel& b) {
  JointModel c{a.value + b.value, {}, 0};
  for (std::size_t k = 0; k < c.rate.size(); ++k) c.rate[k] = a.rate[k] + b.rate[k];
  c.error = (a.error + b.error + rounding_share * (rough_reach(a) + rough_reach(b))) * up;
  return c;
}

JointModel operator-(const JointModel& a, const JointModel& b) {
  JointModel minus = b;
  minus.value = -b.value;
  for (Vector& r : minus.rate) r = -r;
  return a + minus;
}

/// What is left out are products of two deviations from the middles.
JointModel operator*(const JointModel& a, const JointModel& b) {
  JointModel c{a.value * b.value, {}, 0};
  for (std::size_t k = 0; k < c.rate.size(); ++k) c.rate[k] = a.value * b.rate[k] + a.rate[k] * b.value;
  const double first = linear_swing(a), second = linear_swing(b);
  const double reach_a = (magnitude(a.value) + first + a.error) * up,
               reach_b = (magnitude(b.value) + second + b.error) * up;
  c.error = (first * second + reach_a * b.error + a.error * reach_b + rounding_share * reach_a * reach_b) * up;
  return c;
}

JointModel conj(const JointModel& a) {
  JointModel c = a;
  c.value = conj(a.value);
  for (Vector& r : c.rate) r = conj(r);
  return c;
}

namespace {

/// exp(i angle): its second derivative has the magnitude of the slope's square.
JointModel rotation_of(const JointMotion& motion, const JointCell& cell) {
  using B = Ball<double>;
  const auto j = static_cast<std::size_t>(motion.joint);
  const JointAngle angle = joint_angle_of(motion);
  const SinCos<double> at = sin_cos(B::exact(angle.slope) * B::exact(cell.middle[j]) + B::exact(angle.offset));
  const double swing = angle.slope * cell.half[j];
  JointModel rotation = JointModel::constant({at.cos.mid, at.sin.mid});
  rotation.rate[j] = {-swing * at.sin.mid, swing * at.cos.mid};
  const double known = (at.cos.rad + at.sin.rad) * (1 + std::fabs(swing));
  rotation.error = (swing * swing / 2 + known + rounding_share * (1 + std::fabs(swing))) * up;
  return rotation;
}

/// The value of a link's joint over the cell is value + sum rate[k] h[k], up to the error.
struct FollowedValue {
  Ball<double> value;
  std::array<double, max_joints> rate{};
  double error = 0;

  double swing() const {
    double sum = 0;
    for (const double r : rate) sum += std::fabs(r);
    return sum;
  }
};

/// By the mean value theorem; not known where the mechanism may lock.
FollowedValue followed_in_region(const LinkMotion& link, const JointCell& cell) {
  const auto over = link.region->value(static_cast<std::size_t>(link.follows.joint), cell.middle, cell.half);
  if (!over) return {Ball<double>::exact(0), {}, INFINITY};
  const double sign = link.follows.sign;
  FollowedValue found{over->middle * sign, {}, 0};
  for (std::size_t k = 0; k < found.rate.size(); ++k) {
    found.rate[k] = sign * over->slope[k].mid * cell.half[k];
    found.error += over->slope[k].rad * std::fabs(cell.half[k]);
  }
  found.error = (found.error + rounding_share * found.swing() + underflow_slack) * up;
  return found;
}

/// By Taylor's theorem, with the second derivative over the whole cell.
FollowedValue followed_value(const LinkMotion& link, const JointCell& cell, std::size_t joint) {
  if (link.region) return followed_in_region(link, cell);
  using B = Ball<double>;
  const auto followed = static_cast<std::size_t>(link.follows.joint),
             piece = static_cast<std::size_t>(link.follows.piece);
  const double middle = cell.middle[joint], half = cell.half[joint], reach = std::fabs(half);
  const auto at = joint_value<Series<double, 1>>(*link.follows.functions, followed, piece, B::exact(middle));
  const auto over = joint_value<Series<double, 3>>(*link.follows.functions, followed, piece, B(middle, reach));
  const auto coefficient = [](const auto& s, int k) {
    return k < s.terms ? s.c[static_cast<std::size_t>(k)] : B::exact(0);
  };
  const double sign = link.follows.sign;
  const B slope = coefficient(at, 1);
  FollowedValue found{coefficient(at, 0) * sign, {}, 0};
  found.rate[joint] = sign * slope.mid * half;
  found.error = (slope.rad * reach + coefficient(over, 2).magnitude() * reach * reach +
                 rounding_share * std::fabs(found.rate[joint]) + underflow_slack) *
                up;
  return found;
}

/// The error of a place that is not known: of a number no larger than 1, and of one that no scene comes near.
constexpr double any_rotation = 2, any_way = 0x1p100;

/// exp(i (value + sum rate[k] h[k] + rest)): the rest counts at most once, and the square of what is added to the value
/// half.
JointModel rotation_of(const FollowedValue& followed) {
  const Ball<double> degree = one_degree<double>();
  const double swing = followed.swing() * degree.mid,
               rest = (followed.error * degree.mid + rounding_share * swing) * up;
  const SinCos<double> at = sin_cos(followed.value * degree);
  JointModel rotation = JointModel::constant({at.cos.mid, at.sin.mid});
  for (std::size_t k = 0; k < followed.rate.size(); ++k) {
    const double rate = followed.rate[k] * degree.mid;
    rotation.rate[k] = {-rate * at.sin.mid, rate * at.cos.mid};
  }
  const double most = swing + rest;
  rotation.error = (rest + most * most / 2 + (at.cos.rad + at.sin.rad + rounding_share) * (1 + most)) * up;
  if (rotation.error < any_rotation) return rotation;
  rotation = JointModel::constant({1, 0});
  rotation.error = any_rotation * up;
  return rotation;
}

/// Of a link of a mechanism.
PoseModel pose_of(const LinkMotion& link, std::size_t joint, const JointCell& cell, double scale) {
  const FollowedValue followed = followed_value(link, cell, joint);
  if (!link.follows.slides) {
    const JointModel rotation = rotation_of(followed);
    const JointModel pivot = JointModel::constant({link.pivot.x * scale, link.pivot.y * scale});
    return {pivot - rotation * pivot, rotation};
  }
  const Point& d = link.follows.direction;
  const double length = std::sqrt(d.x * d.x + d.y * d.y);
  const Vector along{d.x / length * scale, d.y / length * scale};
  PoseModel pose;
  pose.shift = JointModel::constant({followed.value.mid * along.x, followed.value.mid * along.y});
  for (std::size_t k = 0; k < followed.rate.size(); ++k)
    pose.shift.rate[k] = {followed.rate[k] * along.x, followed.rate[k] * along.y};
  const double parts = followed.value.magnitude() + followed.swing();
  pose.shift.error = (followed.value.rad + followed.error + rounding_share * parts) * scale * up;
  if (pose.shift.error < any_way) return pose;
  pose.shift = JointModel::constant({0, 0});
  pose.shift.error = any_way;
  return pose;
}

}  // namespace

PoseModel pose_of(const JointMotion& motion, const JointCell& cell, double scale) {
  if (std::holds_alternative<FreeMotion>(motion.kind)) {
    PoseModel pose;
    for (const JointMotion& single : single_motions(motion)) pose = pose.of(pose_of(single, cell, scale));
    return pose;
  }
  if (const auto* link = std::get_if<LinkMotion>(&motion.kind))
    return pose_of(*link, static_cast<std::size_t>(motion.joint), cell, scale);
  if (const auto* revolute = std::get_if<Revolute>(&motion.kind)) {
    const JointModel rotation = rotation_of(motion, cell);
    const JointModel pivot = JointModel::constant({revolute->pivot.x * scale, revolute->pivot.y * scale});
    return {pivot - rotation * pivot, rotation};
  }
  const auto j = static_cast<std::size_t>(motion.joint);
  const Point& direction = std::get<Slide>(motion.kind).direction;
  const Vector along{direction.x * scale, direction.y * scale};
  const double way = motion.times * cell.middle[j] + motion.plus, swing = motion.times * cell.half[j];
  PoseModel pose;
  pose.shift = JointModel::constant({way * along.x, way * along.y});
  pose.shift.rate[j] = {swing * along.x, swing * along.y};
  const double parts = std::fabs(motion.times * cell.middle[j]) + std::fabs(motion.plus) + std::fabs(swing);
  pose.shift.error = rounding_share * parts * magnitude(along);
  return pose;
}

}  // namespace taut::internal
