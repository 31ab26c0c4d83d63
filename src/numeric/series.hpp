// Taylor series in time, over balls: for models of the motion that are cheap to evaluate many times.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

#include "numeric/ball.hpp"
#include "numeric/jet.hpp"

namespace taut::internal {

/// The sum of a[i] b[k - i], i = first .. last, in one loop: the middles are computed directly, and one bound covers
/// their rounding. Nothing if a result is not finite.
inline std::optional<Ball<double>> finite_convolution(const Ball<double>* a, const Ball<double>* b, int first, int last,
                                                      int k) {
  double sum = 0, size = 0, spread = 0;
  for (int i = first; i <= last; ++i) {
    const Ball<double>&x = a[i], &y = b[k - i];
    const double product = x.mid * y.mid, x_size = std::fabs(x.mid), y_size = std::fabs(y.mid);
    sum += product;
    size += std::fabs(product);
    spread += (x_size + x.rad) * y.rad + y_size * x.rad;
  }
  // n products and n - 1 additions have an error of less than n + 1 roundings of the sum of their magnitudes. The bound
  // itself has a relative error of less than 4 n roundings.
  const double n = last - first + 1;
  const double bound = (spread + (n + 1) * 0x1p-53 * size) * (1 + 0x1p-45) + n * underflow_slack;
  if (!(bound < INFINITY)) return std::nullopt;
  return Ball<double>(sum, bound);
}

/// c[k] encloses f^(k)(t)/k!, k = 0 .. N, at a point or over a ball of times. The coefficients from `terms` on are
/// exactly zero and cost nothing, as for the polynomials of low degree of which most motions consist.
template <class Real, int N>
struct Series {
  using Number = Real;
  std::array<Ball<Real>, N + 1> c;
  int terms = N + 1;

  static Series constant(double x) { return constant(Ball<Real>::exact(x)); }
  static Series constant(const Ball<Real>& x) {
    Series s;
    s.c.fill(Ball<Real>::exact(0));
    s.c[0] = x;
    s.terms = 1;
    return s;
  }
  /// A polynomial with the given coefficients (ascending) about the ball t: Horner's rule with t + h for t.
  template <class Coefficients>
  static Series polynomial(const Coefficients& coefficients, const Ball<Real>& t) {
    Series s = constant(0.0);
    int degree = -1;
    for (std::size_t i = coefficients.size(); i-- > 0; ++degree) {
      for (int k = std::min(degree + 1, N); k > 0; --k) s.c[k] = s.c[k] * t + s.c[k - 1];
      s.c[0] = s.c[0] * t + as_ball<Real>(coefficients[i]);
    }
    s.terms = std::clamp(degree + 1, 1, N + 1);
    return s;
  }
  /// The polynomial about a time that may have its expansion about an instant nearby.
  template <class Coefficients, class Time>
  requires requires(const Time& t, const Coefficients& given) { t.local(given); }
  static Series polynomial(const Coefficients& given, const Time& t) {
    return t.polynomials ? polynomial(t.local(given), t.since) : polynomial(given, t.t);
  }
  /// The polynomial as a function of s.
  template <class Coefficients>
  static Series polynomial(const Coefficients& coefficients, const TimeFromEnd<Real>& at) {
    Series t = constant(time_since(Ball<Real>::exact(at.end), at.origin));
    t.c[0] = t.c[0] + at.s * at.s * at.direction;
    t.c[1] = at.s * (2 * at.direction);
    t.c[2] = Ball<Real>::exact(at.direction);
    t.terms = 3;
    Series sum = constant(0.0);
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * t + constant(coefficients[i]);
    return sum;
  }
  /// The independent variable.
  static Series variable(const Ball<Real>& t) {
    Series s = constant(t);
    if constexpr (N > 0) {
      s.c[1] = Ball<Real>::exact(1);
      s.terms = 2;
    }
    return s;
  }
  /// A series with this many terms, all of which the caller must set; the rest is zero.
  static Series of_terms(int terms) {
    Series s;
    s.terms = terms;
    std::fill(s.c.begin() + terms, s.c.end(), Ball<Real>::exact(0));
    return s;
  }
};

template <class Real, int N>
Series<Real, N> operator-(const Series<Real, N>& a) {
  auto r = Series<Real, N>::of_terms(a.terms);
  for (int k = 0; k <= N && k < r.terms; ++k) r.c[k] = -a.c[k];
  return r;
}
template <class Real, int N>
Series<Real, N> operator+(const Series<Real, N>& a, const Series<Real, N>& b) {
  auto r = Series<Real, N>::of_terms(std::max(a.terms, b.terms));
  for (int k = 0; k <= N && k < r.terms; ++k) r.c[k] = a.c[k] + b.c[k];
  return r;
}
template <class Real, int N>
Series<Real, N> operator-(const Series<Real, N>& a, const Series<Real, N>& b) {
  auto r = Series<Real, N>::of_terms(std::max(a.terms, b.terms));
  for (int k = 0; k <= N && k < r.terms; ++k) r.c[k] = a.c[k] - b.c[k];
  return r;
}
/// The sum of a[i] b[k - i], i = first .. last.
template <class Real>
Ball<Real> convolution(const Ball<Real>* a, const Ball<Real>* b, int first, int last, int k) {
  if constexpr (std::is_same_v<Real, double>) {
    if (const auto sum = finite_convolution(a, b, first, last, k)) return *sum;
  }
  Ball<Real> sum = a[first] * b[k - first];
  for (int i = first + 1; i <= last; ++i) sum = sum + a[i] * b[k - i];
  return sum;
}
template <class Real, int N>
Series<Real, N> operator*(const Series<Real, N>& a, const Series<Real, N>& b) {
  auto r = Series<Real, N>::of_terms(std::min(a.terms + b.terms - 1, N + 1));
  for (int k = 0; k <= N && k < r.terms; ++k) {
    r.c[k] = convolution(a.c.data(), b.c.data(), std::max(0, k - b.terms + 1), std::min(k, a.terms - 1), k);
  }
  return r;
}
template <class Real, int N>
Series<Real, N> operator*(const Series<Real, N>& a, const Ball<Real>& b) {
  auto r = Series<Real, N>::of_terms(a.terms);
  for (int k = 0; k <= N && k < r.terms; ++k) r.c[k] = a.c[k] * b;
  return r;
}
template <class Real, int N>
Series<Real, N> operator/(const Series<Real, N>& a, const Series<Real, N>& b) {
  auto q = Series<Real, N>::of_terms(b.terms == 1 ? a.terms : N + 1);
  for (int k = 0; k <= N && k < q.terms; ++k) {
    Ball<Real> x = a.c[k];
    for (int i = std::max(0, k - b.terms + 1); i < k; ++i) x = x - q.c[i] * b.c[k - i];
    q.c[k] = x / b.c[0];
  }
  return q;
}
template <class Real, int N>
Series<Real, N> sqrt(const Series<Real, N>& a) {
  auto r = Series<Real, N>::of_terms(a.terms == 1 ? 1 : N + 1);
  r.c[0] = sqrt(a.c[0]);
  for (int k = 1; k <= N && k < r.terms; ++k) {
    Ball<Real> x = a.c[k];
    for (int i = 1; i < k; ++i) x = x - r.c[i] * r.c[k - i];
    r.c[k] = x / (r.c[0] * 2.0);
  }
  return r;
}
template <class Real, int N>
void sin_cos(const Series<Real, N>& a, Series<Real, N>& sine, Series<Real, N>& cosine) {
  sine = cosine = Series<Real, N>::of_terms(a.terms == 1 ? 1 : N + 1);
  const SinCos<Real> start = sin_cos(a.c[0]);
  sine.c[0] = start.sin;
  cosine.c[0] = start.cos;
  std::array<Ball<Real>, N + 1> slope;  // k times the coefficient
  for (int k = 1; k <= N && k < a.terms; ++k) slope[k] = a.c[k] * static_cast<double>(k);
  for (int k = 1; k <= N && k < sine.terms; ++k) {
    const Ball<Real>& share = reciprocal<Real>(k);
    const int last = std::min(k, a.terms - 1);
    sine.c[k] = convolution(slope.data(), cosine.c.data(), 1, last, k) * share;
    cosine.c[k] = -convolution(slope.data(), sine.c.data(), 1, last, k) * share;
  }
}

}  // namespace taut::internal
