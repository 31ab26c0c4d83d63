// Where a body is, as a function of joint values: to first order over a cell, with a bound of the rest.
#pragma once

#include <array>

#include "geometry/vector.hpp"
#include "scene/linkage.hpp"
#include "taut/envelope.hpp"

namespace taut::internal {

/// A box of joint values, by its middle and half its sides.
struct JointCell {
  std::array<double, max_joints> middle{}, half{};
};

/// A complex number z(h) that depends on the joints, h[k] from -1 to 1 across the cell. The law: for all such h,
/// |z(h) - (value + sum rate[k] h[k])| <= error.
struct JointModel {
  Vector value;
  std::array<Vector, max_joints> rate{};
  double error = 0;

  static JointModel constant(Vector v) { return {v, {}, 0}; }
  /// Bounds the way from the middle's value.
  double swing() const;
  /// Bounds the magnitude.
  double reach() const;
};
JointModel operator+(const JointModel& a, const JointModel& b);
JointModel operator-(const JointModel& a, const JointModel& b);
JointModel operator*(const JointModel& a, const JointModel& b);
JointModel conj(const JointModel& a);

/// The body's point v is at shift + rotation v in the other frame.
struct PoseModel {
  JointModel shift = JointModel::constant({0, 0}), rotation = JointModel::constant({1, 0});

  JointModel place(Vector v) const { return shift + rotation * JointModel::constant(v); }
  /// First `inner`, then this.
  PoseModel of(const PoseModel& inner) const { return {shift + rotation * inner.shift, rotation * inner.rotation}; }
  /// The way back; turns have length 1.
  PoseModel inverse() const { return {conj(rotation) * (JointModel::constant({0, 0}) - shift), conj(rotation)}; }
};

/// Of a body in the frame of its parent. Pivots and directions are multiplied by `scale`, a power of two.
PoseModel pose_of(const JointMotion& motion, const JointCell& cell, double scale);

}  // namespace taut::internal
