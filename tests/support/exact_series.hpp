// Taylor coefficients of a function over an interval: c[k] contains f^(k)(t) / k! for every t in it.
#pragma once

#include <array>
#include <vector>

#include "support/exact_interval.hpp"

namespace taut::testing::exact {

template <class I, int N>
struct Series {
  static constexpr int order = N;
  std::array<I, N + 1> c;

  Series() = default;
  explicit Series(const I& constant) { c[0] = constant; }

  friend Series operator+(Series a, const Series& b) {
    for (int k = 0; k <= N; ++k) a.c[k] = a.c[k] + b.c[k];
    return a;
  }
  friend Series operator-(Series a, const Series& b) {
    for (int k = 0; k <= N; ++k) a.c[k] = a.c[k] - b.c[k];
    return a;
  }
  friend Series operator*(const Series& a, const Series& b) {
    Series r;
    for (int k = 0; k <= N; ++k) {
      r.c[k] = a.c[0] * b.c[k];
      for (int j = 1; j <= k; ++j) r.c[k] = r.c[k] + a.c[j] * b.c[k - j];
    }
    return r;
  }
  friend Series operator*(const I& x, Series a) {
    for (int k = 0; k <= N; ++k) a.c[k] = x * a.c[k];
    return a;
  }
};

/// r with r^2 = a, for a that is positive throughout.
template <class I, int N>
Series<I, N> sqrt(const Series<I, N>& a) {
  Series<I, N> r;
  r.c[0] = sqrt(a.c[0]);
  const I twice = r.c[0] + r.c[0];
  for (int k = 1; k <= N; ++k) {
    I rest = a.c[k];
    for (int j = 1; j < k; ++j) rest = rest - r.c[j] * r.c[k - j];
    r.c[k] = rest / twice;
  }
  return r;
}

template <class I, int N>
void sin_cos(const Series<I, N>& a, Series<I, N>& s, Series<I, N>& c) {
  sin_cos(a.c[0], s.c[0], c.c[0]);
  for (int k = 1; k <= N; ++k) {
    I up(0.0), down(0.0);
    for (int j = 1; j <= k; ++j) {
      const I slope = I(j) * a.c[j];
      up = up + slope * c.c[k - j];
      down = down - slope * s.c[k - j];
    }
    s.c[k] = up / I(k);
    c.c[k] = down / I(k);
  }
}

/// Of a polynomial with these coefficients, in ascending powers.
template <class I, int N>
Series<I, N> polynomial(const std::vector<I>& p, const I& t) {
  Series<I, N> r;
  for (std::size_t k = p.size(); k-- > 0;) {
    for (int j = N; j > 0; --j) r.c[j] = r.c[j] * t + r.c[j - 1];
    r.c[0] = r.c[0] * t + p[k];
  }
  return r;
}

}  // namespace taut::testing::exact
