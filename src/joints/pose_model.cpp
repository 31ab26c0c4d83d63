#include "joints/pose_model.hpp"

#include <cmath>

#include "numeric/trig.hpp"

namespace taut::internal {
namespace {

/// More than the rounding of the few operations on bounds.
constexpr double up = 1 + 0x1p-40;
/// More than what rounds in a product or a sum, as a share of the magnitudes.
constexpr double rounding_share = 0x1p-48;

double magnitude(Vector v) { return std::sqrt(dot(v, v)) * up; }

}  // namespace

double JointModel::swing() const {
  double sum = error;
  for (const Vector& r : rate) sum += magnitude(r);
  return sum * up;
}

double JointModel::reach() const { return (magnitude(value) + swing()) * up; }

JointModel operator+(const JointModel& a, const JointModel& b) {
  JointModel c{a.value + b.value, {}, 0};
  for (std::size_t k = 0; k < c.rate.size(); ++k) c.rate[k] = a.rate[k] + b.rate[k];
  c.error = (a.error + b.error + rounding_share * (a.reach() + b.reach())) * up;
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
  double first = 0, second = 0;
  for (std::size_t k = 0; k < c.rate.size(); ++k) {
    c.rate[k] = a.value * b.rate[k] + a.rate[k] * b.value;
    first += magnitude(a.rate[k]);
    second += magnitude(b.rate[k]);
  }
  const double reach_a = a.reach(), reach_b = b.reach();
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

}  // namespace

PoseModel pose_of(const JointMotion& motion, const JointCell& cell, double scale) {
  if (std::holds_alternative<FreeMotion>(motion.kind)) {
    PoseModel pose;
    for (const JointMotion& single : single_motions(motion)) pose = pose.of(pose_of(single, cell, scale));
    return pose;
  }
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
