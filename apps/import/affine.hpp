// Placing what a drawing has in its own coordinates.
#pragma once

#include <cmath>

#include "taut/geometry.hpp"

namespace taut::drawing {

/// (x, y) goes to (a x + c y + e, b x + d y + f), as SVG has it.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  /// Of a direction, or a length with one.
  Point turn(const Point& v) const { return {a * v.x + c * v.y, b * v.x + d * v.y}; }
  Point operator()(const Point& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First `inner`, then this one.
  Affine operator*(const Affine& inner) const {
    const Point x = turn({inner.a, inner.b}), y = turn({inner.c, inner.d});
    const Point o = (*this)({inner.e, inner.f});
    return {x.x, x.y, y.x, y.y, o.x, o.y};
  }
};

inline Affine scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }
inline Affine translation(double x, double y) { return {1, 0, 0, 1, x, y}; }
inline Affine rotation(double degrees) {
  // Quarter turns are exact: most drawings have no others.
  const double quarters = degrees / 90;
  if (quarters == std::nearbyint(quarters)) {
    const int k = static_cast<int>(std::fmod(quarters, 4) + 4) % 4;
    const double cosines[] = {1, 0, -1, 0};
    return {cosines[k], cosines[(k + 3) % 4], -cosines[(k + 3) % 4], cosines[k], 0, 0};
  }
  const double angle = degrees * (3.14159265358979323846 / 180);
  return {std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
}

}  // namespace taut::drawing
