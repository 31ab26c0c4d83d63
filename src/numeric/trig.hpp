// Sine and cosine with proved error bounds, the same bits on every platform (the C library promises neither).
#pragma once

#include "numeric/ball.hpp"

namespace taut {

/// The number nearest to pi.
template <class Real>
Real pi();

template <class Real>
struct SinCos {
  Ball<Real> sin, cos;
};

/// Both functions over the ball x (radians).
SinCos<double> sin_cos(const Ball<double>& x);
template <class Real>
SinCos<Real> sin_cos(const Ball<Real>& x);

}  // namespace taut
