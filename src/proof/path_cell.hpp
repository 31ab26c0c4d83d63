// Bodies over a box of joint values, as a verifier of logs about paths bounds them: by mean values.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numeric/ball.hpp"
#include "taut/path.hpp"

namespace taut::internal::proof {

using Enclosure = Ball<double>;

/// A box of joint values, each side in units of 2^-48 of the joint's range.
struct PathCell {
  static constexpr std::int64_t whole = std::int64_t{1} << 48;
  std::array<std::int64_t, max_joints> lo{}, side{};
};

/// A function of the joint values over a cell: its value at the middle, all its values, and all its derivatives. So it
/// is within `middle` plus the sum of slope[k] times (value of joint k - its middle).
struct CellFunction {
  Enclosure middle, range;
  std::array<Enclosure, max_joints> slope{};

  static CellFunction constant(double x) { return {Enclosure::exact(x), Enclosure::exact(x), {}}; }
};
CellFunction operator+(const CellFunction& a, const CellFunction& b);
CellFunction operator-(const CellFunction& a, const CellFunction& b);
CellFunction operator*(const CellFunction& a, const CellFunction& b);

struct CellPoint {
  CellFunction x, y;
};

/// The body's point (u, v) is at (x + c u - s v, y + s u + c v).
struct CellPose {
  CellFunction x = CellFunction::constant(0), y = CellFunction::constant(0), c = CellFunction::constant(1),
               s = CellFunction::constant(0);

  CellPoint place(const Point& p) const;
  /// First `inner`, then this.
  CellPose of(const CellPose& inner) const;
  CellPose inverse() const;
};

/// A cell with its joint values.
class CellValues {
 public:
  CellValues(const PathProblem& problem, const PathCell& cell);

  /// Certainly no less than a function's least and no more than its largest value.
  double least(const CellFunction& f) const;
  double largest(const CellFunction& f) const;
  /// Half the side of a joint, rounded up.
  double half(std::size_t joint) const { return half_[joint]; }
  double lo(std::size_t joint) const { return lo_[joint]; }
  double hi(std::size_t joint) const { return hi_[joint]; }
  /// Is a mechanism not shown to move all over the cell as it continues the drawn pose?
  bool may_lock(const PathProblem& problem) const;
  /// Of a body in the frame of its parent.
  CellPose pose(const JointMotion& motion) const;

 private:
  CellFunction value(int joint, double times, double plus) const;
  CellFunction value(const LinkMotion& link, int joint) const;
  CellFunction value_in_region(const LinkMotion& link) const;
  double variation(const CellFunction& f) const;

  std::array<double, max_joints> lo_{}, hi_{}, middle_{}, half_{};
};

}  // namespace taut::internal::proof
