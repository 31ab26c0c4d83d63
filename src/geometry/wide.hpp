// Numbers for points on curves: four times as long as doubles, so that what they round is far below what any polygon's
// vertex is moved by.
#pragma once

#include <algorithm>
#include <cmath>

#include "numeric/ball.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::curve {

using Wide = WideFloat<192>;
using WideBall = Ball<Wide>;

/// An index of a container.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A point on a curve, or one that controls it, with a bound of its error.
struct WidePoint {
  WideBall x, y;

  static WidePoint of(const Point& p) { return {WideBall::exact(p.x), WideBall::exact(p.y)}; }
  /// Is it known to the last bit? Only points that are given by doubles are.
  bool is_exact() const { return x.rad == 0 && y.rad == 0; }
  Point rounded() const { return {RealTraits<Wide>::to_double(x.mid), RealTraits<Wide>::to_double(y.mid)}; }
};

inline WidePoint operator+(const WidePoint& a, const WidePoint& b) { return {a.x + b.x, a.y + b.y}; }
inline WidePoint operator-(const WidePoint& a, const WidePoint& b) { return {a.x - b.x, a.y - b.y}; }
inline WidePoint operator*(const WidePoint& a, double s) { return {a.x * s, a.y * s}; }
inline WideBall dot(const WidePoint& a, const WidePoint& b) { return a.x * b.x + a.y * b.y; }

/// The sign of (b - a) x (c - a) if doubles show it, else 0. With d a bound of how far rounded coordinates are off,
/// those of differences are off by 2d and a rounding error, which is less than 4d in all.
inline int turn_in_doubles(const WidePoint& a, const WidePoint& b, const WidePoint& c) {
  const Point p = a.rounded(), q = b.rounded(), r = c.rounded();
  double largest = 0, radius = 0;
  for (const double x : {p.x, p.y, q.x, q.y, r.x, r.y}) largest = std::max(largest, std::fabs(x));
  for (const WidePoint* point : {&a, &b, &c}) radius = std::max({radius, point->x.rad, point->y.rad});
  const double d = 0x1p-52 * largest + 2 * radius;
  const double ux = q.x - p.x, uy = q.y - p.y, vx = r.x - p.x, vy = r.y - p.y;
  const double left = ux * vy, right = uy * vx;
  const double error = 4 * d * (std::fabs(ux) + std::fabs(uy) + std::fabs(vx) + std::fabs(vy) + 16 * d) +
                       0x1p-50 * (std::fabs(left) + std::fabs(right)) + 0x1p-1000;
  return left - right > error ? 1 : right - left > error ? -1 : 0;
}

/// The sign of (b - a) x (c - a) if it is certain, else 0.
inline int turn(const WidePoint& a, const WidePoint& b, const WidePoint& c) {
  if (const int sign = turn_in_doubles(a, b, c)) return sign;
  const WidePoint u = b - a, v = c - a;
  return (u.x * v.y - u.y * v.x).sign();
}

}  // namespace taut::internal::curve
