// Sine and cosine with proved error bounds, the same bits on every platform (the C library promises neither).
#pragma once

#include "numeric/ball.hpp"

namespace taut::internal {

/// The number nearest to pi.
template <class Real>
Real pi();

template <class Real>
struct SinCos {
  Ball<Real> sin, cos;
};

/// Rotates the pair by k quarter turns.
template <class Real>
SinCos<Real> quarter_turns(const Ball<Real>& s, const Ball<Real>& c, int k) {
  switch (k & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// Both functions over the ball x (radians).
SinCos<double> sin_cos(const Ball<double>& x);
template <class Real>
SinCos<Real> sin_cos(const Ball<Real>& x);
/// Both functions of an angle that is the sum of two doubles, |hi| < 2^40 and |lo| < 2^-10: to 2^-50, regardless of its
/// size.
SinCos<double> sin_cos_of_sum(double hi, double lo);

}  // namespace taut::internal
