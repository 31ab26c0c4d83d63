// Numbers for points on curves: four times as long as doubles, so that what they round is far below what any polygon's
// vertex is moved by.
#pragma once

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

/// The sign of (b - a) x (c - a) if it is certain, else 0.
inline int turn(const WidePoint& a, const WidePoint& b, const WidePoint& c) {
  const WidePoint u = b - a, v = c - a;
  return (u.x * v.y - u.y * v.x).sign();
}

}  // namespace taut::internal::curve
