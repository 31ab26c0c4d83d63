// Taylor series in time, over balls: for models of the motion that are cheap to evaluate many times.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "numeric/trig.hpp"

namespace taut {

/// c[k] encloses f^(k)(t)/k!, k = 0 .. N, at a point or over a ball of times.
template <class Real, int N>
struct Series {
  using Number = Real;
  std::array<Ball<Real>, N + 1> c;

  static Series constant(double x) {
    Series s;
    s.c.fill(Ball<Real>::exact(0));
    s.c[0] = Ball<Real>::exact(x);
    return s;
  }
  /// A polynomial with the given coefficients (ascending) about the ball t: Horner's rule with t + h for t.
  template <class Coefficients>
  static Series polynomial(const Coefficients& coefficients, const Ball<Real>& t) {
    Series s = constant(0.0);
    int degree = -1;
    for (std::size_t i = coefficients.size(); i-- > 0; ++degree) {
      for (int k = std::min(degree + 1, N); k > 0; --k) s.c[k] = s.c[k] * t + s.c[k - 1];
      s.c[0] = s.c[0] * t + Ball<Real>::exact(coefficients[i]);
    }
    return s;
  }
};

template <class Real, int N>
Series<Real, N> operator-(const Series<Real, N>& a) {
  Series<Real, N> r;
  for (int k = 0; k <= N; ++k) r.c[k] = -a.c[k];
  return r;
}
template <class Real, int N>
Series<Real, N> operator+(const Series<Real, N>& a, const Series<Real, N>& b) {
  Series<Real, N> r;
  for (int k = 0; k <= N; ++k) r.c[k] = a.c[k] + b.c[k];
  return r;
}
template <class Real, int N>
Series<Real, N> operator-(const Series<Real, N>& a, const Series<Real, N>& b) {
  Series<Real, N> r;
  for (int k = 0; k <= N; ++k) r.c[k] = a.c[k] - b.c[k];
  return r;
}
template <class Real, int N>
Series<Real, N> operator*(const Series<Real, N>& a, const Series<Real, N>& b) {
  Series<Real, N> r;
  for (int k = 0; k <= N; ++k) {
    r.c[k] = a.c[0] * b.c[k];
    for (int i = 1; i <= k; ++i) r.c[k] = r.c[k] + a.c[i] * b.c[k - i];
  }
  return r;
}
template <class Real, int N>
Series<Real, N> operator/(const Series<Real, N>& a, const Series<Real, N>& b) {
  Series<Real, N> q;
  for (int k = 0; k <= N; ++k) {
    Ball<Real> x = a.c[k];
    for (int i = 0; i < k; ++i) x = x - q.c[i] * b.c[k - i];
    q.c[k] = x / b.c[0];
  }
  return q;
}
template <class Real, int N>
Series<Real, N> sqrt(const Series<Real, N>& a) {
  Series<Real, N> r;
  r.c[0] = sqrt(a.c[0]);
  for (int k = 1; k <= N; ++k) {
    Ball<Real> x = a.c[k];
    for (int i = 1; i < k; ++i) x = x - r.c[i] * r.c[k - i];
    r.c[k] = x / (r.c[0] * 2.0);
  }
  return r;
}
template <class Real, int N>
void sin_cos(const Series<Real, N>& a, Series<Real, N>& sine, Series<Real, N>& cosine) {
  const SinCos<Real> start = sin_cos(a.c[0]);
  sine.c[0] = start.sin;
  cosine.c[0] = start.cos;
  for (int k = 1; k <= N; ++k) {
    Ball<Real> s = Ball<Real>::exact(0), c = Ball<Real>::exact(0);
    for (int j = 1; j <= k; ++j) {
      const Ball<Real> weighted = a.c[j] * static_cast<double>(j);
      s = s + weighted * cosine.c[k - j];
      c = c - weighted * sine.c[k - j];
    }
    const Ball<Real> divisor = Ball<Real>::exact(k);
    sine.c[k] = s / divisor;
    cosine.c[k] = c / divisor;
  }
}

}  // namespace taut
