// World positions of a moving body in extended precision, with bounds over intervals of time: for the oracle.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "taut/scene.hpp"

namespace taut::testing {

using Real = long double;

struct Vec {
  Real x = 0, y = 0;
};
inline Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator*(Real s, const Vec& a) { return {s * a.x, s * a.y}; }
inline Real cross(const Vec& a, const Vec& b) { return a.x * b.y - a.y * b.x; }
inline Real dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y; }
inline Real length(const Vec& a) { return std::sqrt(dot(a, a)); }

/// Origin and axis of the moving frame at an instant.
struct Frame {
  Vec origin, axis;
};

/// What holds throughout an interval of time. Bounds are infinite where the form of the motion is singular.
struct FrameBounds {
  Real rate = 0;          ///< |theta'|
  Real rate_change = 0;   ///< |theta''|
  Real acceleration = 0;  ///< |o''|
  Real origin_way = 0;    ///< |o(t) - o(middle)|
  Real angle_way = 0;     ///< |theta(t) - theta(middle)|
  Vec origin_velocity;    ///< o' in the middle
  Real middle_rate = 0;   ///< theta' in the middle
};

/// One piece of a motion. The polynomials are as in MotionPiece.
class BrutePiece {
 public:
  explicit BrutePiece(const MotionPiece& piece) : piece_(piece) {}

  Frame at(Real t) const;
  /// Over [middle - half, middle + half].
  FrameBounds over(Real middle, Real half) const;
  /// The largest number that arises in placing a point of this distance from the origin at a time up to |t|: rounding
  /// errors are a few units of Real in proportion to it.
  Real magnitude(Real t, Real radius) const;

 private:
  Vec pivot() const;
  void bound_rotation(Real middle, Real half, FrameBounds& b) const;

  MotionPiece piece_;
};

}  // namespace taut::testing
