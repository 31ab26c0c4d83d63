// Angles in degrees, as mechanisms have them: multiples of 90 are exact.
#pragma once

#include <cmath>
#include <cstdint>

#include "numeric/jet.hpp"
#include "numeric/series.hpp"
#include "numeric/trig.hpp"
#include "taut/geometry.hpp"

namespace taut::internal {

/// pi / 180.
template <class Real>
const Ball<Real>& one_degree() {
  if constexpr (std::is_same_v<Real, double>) {
    static const Ball<double> degree = detail::in_doubles(one_degree<Real320>());
    return degree;
  } else {
    static const Ball<Real> degree = Ball<Real>(pi<Real>(), 4 * unit_roundoff<Real>()) / Ball<Real>::exact(180);
    return degree;
  }
}

/// The number of quarter turns next to an angle in degrees.
inline double quarter_turns_in(double degrees) {
  const double about = degrees / 90;
  return std::fabs(about) < 0x1p30 ? std::nearbyint(about) : 0;
}

/// Subtracts the quarter turns next to an angle from it, and returns how many.
template <class J>
double take_quarter_turns(J& angle) {
  using Real = typename J::Number;
  Ball<Real>& value = [&]() -> Ball<Real>& {
    if constexpr (requires { angle.v; }) {
      return angle.v;
    } else {
      return angle.c[0];
    }
  }();
  const double turns = quarter_turns_in(RealTraits<Real>::to_double(value.mid));
  if (turns != 0) value = value - Ball<Real>::exact(90 * turns);
  return turns;
}

/// The sine and cosine of an angle in degrees, exact for multiples of 90.
template <class J>
void sin_cos_degrees(J angle, J& sine, J& cosine) {
  const double turns = take_quarter_turns(angle);
  sin_cos(angle * one_degree<typename J::Number>(), sine, cosine);
  const int k = static_cast<int>(static_cast<std::int64_t>(turns) & 3);
  if (k == 0) return;
  const J s = sine, c = cosine;
  if (k == 1) {
    sine = c;
    cosine = -s;
  } else if (k == 2) {
    sine = -s;
    cosine = -c;
  } else {
    sine = -c;
    cosine = s;
  }
}

/// The length of a slide's direction.
template <class Real>
Ball<Real> length_of_direction(const Point& d) {
  const Ball<Real> x = Ball<Real>::exact(d.x), y = Ball<Real>::exact(d.y);
  if (d.x == 0) return Ball<Real>::exact(std::fabs(d.y));
  if (d.y == 0) return Ball<Real>::exact(std::fabs(d.x));
  return sqrt(x * x + y * y);
}

}  // namespace taut::internal
