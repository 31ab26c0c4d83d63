// Functions that are analytic on a disc, known by their first Taylor coefficients and a bound of the rest.
//
// With time as the middle plus R s, a function is sum c_k s^k + w(s), where w is analytic with a sum of the magnitudes
// of its coefficients of at most `error`. That sum is a norm, and the norm of a product is at most the product of the
// norms (a Banach algebra): so one number bounds values and all derivatives of what is not known. Compare Taylor models
// (Makino and Berz) and radii polynomials (Day, Lessard, Mischaikow).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/degrees.hpp"

namespace taut::internal {

/// Further coefficients of the sine and the cosine of a series, by s' = c a' and c' = -s a'; the first ones are there.
template <class Series>
void sin_cos_coefficients(const Series& a, Series& sine, Series& cosine) {
  for (int k = 1; k < sine.terms; ++k) {
    double of_sine = 0, of_cosine = 0;
    for (int i = 1; i <= std::min(k, a.terms - 1); ++i) {
      const double slope = i * a.c[static_cast<std::size_t>(i)];
      of_sine += slope * cosine.c[static_cast<std::size_t>(k - i)];
      of_cosine += slope * sine.c[static_cast<std::size_t>(k - i)];
    }
    sine.c[static_cast<std::size_t>(k)] = of_sine / k;
    cosine.c[static_cast<std::size_t>(k)] = -of_cosine / k;
  }
}

class DiscSeries {
 public:
  using Number = double;
  static constexpr int order = 17;

  static DiscSeries constant(double x) { return constant(Ball<double>::exact(x)); }
  static DiscSeries constant(const Ball<double>& x) {
    DiscSeries s;
    s.c[0] = x.mid;
    s.error = x.rad;
    return s;
  }
  /// The time, where the disc has this middle and radius.
  static DiscSeries time(double middle, double radius) {
    DiscSeries s = constant(middle);
    s.c[1] = radius;
    s.terms = 2;
    return s;
  }

  /// Bounds the magnitude on the disc.
  double norm() const { return (sum_of_magnitudes(0) + error) * (1 + 0x1p-45); }
  double sum_of_magnitudes(int first) const {
    double sum = 0;
    for (int k = first; k < terms; ++k) sum += std::fabs(c[static_cast<std::size_t>(k)]);
    return sum * (1 + 0x1p-45);
  }

  std::array<double, order + 1> c{};
  double error = 0;
  int terms = 1;  ///< coefficients from here on are 0

  friend DiscSeries operator-(DiscSeries a) {
    for (double& x : a.c) x = -x;
    return a;
  }
  friend DiscSeries operator+(const DiscSeries& a, const DiscSeries& b) { return sum(a, b, 1); }
  friend DiscSeries operator-(const DiscSeries& a, const DiscSeries& b) { return sum(a, b, -1); }
  friend DiscSeries operator*(const DiscSeries& a, const DiscSeries& b) {
    DiscSeries r;
    r.terms = std::min(a.terms + b.terms - 1, order + 1);
    for (int i = 0; i < a.terms; ++i) {
      const double x = a.c[static_cast<std::size_t>(i)];
      const int last = std::min(b.terms, order + 1 - i);
      for (int j = 0; j < last; ++j) r.c[static_cast<std::size_t>(i + j)] += x * b.c[static_cast<std::size_t>(j)];
    }
    const double na = a.sum_of_magnitudes(0), nb = b.sum_of_magnitudes(0);
    // Each coefficient is a sum of at most order + 1 products.
    r.error = (na * b.error + nb * a.error + a.error * b.error + (order + 3) * 0x1p-53 * na * nb +
               cut_off(a, b, [](int) { return 1.0; })) *
                  (1 + 0x1p-40) +
              underflow_slack;
    return r;
  }
  friend DiscSeries operator*(const DiscSeries& a, const Ball<double>& b) {
    DiscSeries r = a;
    for (int k = 0; k < r.terms; ++k) r.c[static_cast<std::size_t>(k)] *= b.mid;
    const double na = a.sum_of_magnitudes(0);
    r.error = (na * (b.rad + 0x1p-52 * std::fabs(b.mid)) + a.error * b.magnitude()) * (1 + 0x1p-40) + underflow_slack;
    return r;
  }

  /// By the differential equation s' = c a', c' = -s a': what the truncated series lack of it bounds their error, which
  /// grows by at most the exponential of the norm of the varying part of a.
  friend void sin_cos(const DiscSeries& a, DiscSeries& sine, DiscSeries& cosine) {
    const SinCos<double> start = sin_cos(Ball<double>::exact(a.c[0]));
    DiscSeries si, co;
    si.terms = co.terms = a.terms == 1 ? 1 : order + 1;
    si.c[0] = start.sin.mid;
    co.c[0] = start.cos.mid;
    sin_cos_coefficients(a, si, co);
    const double way = a.sum_of_magnitudes(1), ns = si.sum_of_magnitudes(0), nc = co.sum_of_magnitudes(0);
    DiscSeries slope = a;  // i a_i / k bounds the term's share of coefficient k
    slope.c[0] = 0;
    for (int i = 1; i < a.terms; ++i) slope.c[static_cast<std::size_t>(i)] *= i;
    const auto share = [](int k) { return 1.0 / k; };
    const double rounding = (order + 4) * 0x1p-53 * way;
    const double lack =
        start.sin.rad + start.cos.rad + cut_off(slope, co, share) + cut_off(slope, si, share) + rounding * (ns + nc);
    const double grown = way < 16 ? lack * exponential_above(way) : std::numeric_limits<double>::infinity();
    // |sin w| + |cos w - 1| is at most 1.3 |w|; the sine and the cosine themselves may be larger than their series.
    const double from_error =
        a.error < 0.5 ? 1.3 * a.error * (ns + nc + 2 * grown) : std::numeric_limits<double>::infinity();
    sine = si;
    cosine = co;
    sine.error = cosine.error = (grown + from_error) * (1 + 0x1p-40) + underflow_slack;
  }

 private:
  /// A bound of e^x, 0 <= x < 16, the same on every platform: (1 - x/64)^-64.
  static double exponential_above(double x) {
    double power = 1 / (1 - x / 64) * (1 + 0x1p-50);
    for (int k = 0; k < 6; ++k) power *= power;
    return power * (1 + 0x1p-40);
  }
  static DiscSeries sum(const DiscSeries& a, const DiscSeries& b, double sign) {
    DiscSeries r;
    r.terms = std::max(a.terms, b.terms);
    double size = 0;
    for (int k = 0; k < r.terms; ++k) {
      const std::size_t i = static_cast<std::size_t>(k);
      r.c[i] = a.c[i] + sign * b.c[i];
      size += std::fabs(r.c[i]);
    }
    r.error = (a.error + b.error + 0x1p-53 * size) * (1 + 0x1p-40) + underflow_slack;
    return r;
  }
  /// The terms of the product beyond the order, each times a weight of its power.
  template <class Weight>
  static double cut_off(const DiscSeries& a, const DiscSeries& b, const Weight& weight) {
    double rest = 0;
    for (int i = a.terms - 1; i > 0 && i + b.terms - 1 > order; --i) {
      double sum = 0;
      for (int j = b.terms - 1; i + j > order; --j) sum += std::fabs(b.c[static_cast<std::size_t>(j)]) * weight(i + j);
      rest += std::fabs(a.c[static_cast<std::size_t>(i)]) * sum;
    }
    return rest * (1 + 0x1p-40);
  }
};

/// A truncated power series without bounds: as many coefficients as all that it is made of have.
struct RoughSeries {
  using Number = double;
  static constexpr int all = DiscSeries::order + 1;

  static RoughSeries constant(double x) {
    RoughSeries s;
    s.c[0] = x;
    return s;
  }
  static RoughSeries constant(const Ball<double>& x) { return constant(x.mid); }

  std::array<double, all> c{};
  int known = all;  ///< coefficients from here on are not known
  int terms = 1;    ///< and from here on 0

  friend RoughSeries operator-(RoughSeries a) {
    for (double& x : a.c) x = -x;
    return a;
  }
  friend RoughSeries operator+(const RoughSeries& a, const RoughSeries& b) { return sum(a, b, 1); }
  friend RoughSeries operator-(const RoughSeries& a, const RoughSeries& b) { return sum(a, b, -1); }
  friend RoughSeries operator*(const RoughSeries& a, const RoughSeries& b) {
    RoughSeries r = of(a, b, a.terms + b.terms - 1);
    for (int i = 0; i < std::min(a.terms, r.terms); ++i) {
      const int last = std::min(b.terms, r.terms - i);
      for (int j = 0; j < last; ++j)
        r.c[static_cast<std::size_t>(i + j)] += a.c[static_cast<std::size_t>(i)] * b.c[static_cast<std::size_t>(j)];
    }
    return r;
  }
  friend RoughSeries operator*(RoughSeries a, const Ball<double>& b) {
    for (double& x : a.c) x *= b.mid;
    return a;
  }
  friend void sin_cos(const RoughSeries& a, RoughSeries& sine, RoughSeries& cosine) {
    const SinCos<double> start = sin_cos(Ball<double>::exact(a.c[0]));
    RoughSeries si, co;
    si.known = co.known = a.known;
    si.terms = co.terms = a.terms == 1 ? 1 : a.known;
    si.c[0] = start.sin.mid;
    co.c[0] = start.cos.mid;
    sin_cos_coefficients(a, si, co);
    sine = si;
    cosine = co;
  }

 private:
  static RoughSeries of(const RoughSeries& a, const RoughSeries& b, int terms) {
    RoughSeries r;
    r.known = std::min(a.known, b.known);
    r.terms = std::min(terms, r.known);
    return r;
  }
  static RoughSeries sum(const RoughSeries& a, const RoughSeries& b, double sign) {
    RoughSeries r = of(a, b, std::max(a.terms, b.terms));
    for (int k = 0; k < r.terms; ++k) {
      const std::size_t i = static_cast<std::size_t>(k);
      r.c[i] = a.c[i] + sign * b.c[i];
    }
    return r;
  }
};

inline double take_quarter_turns(DiscSeries& angle) {
  const double turns = quarter_turns_in(angle.c[0]);
  const TwoDoubles rest = two_sum(angle.c[0], -90 * turns);
  angle.c[0] = rest.hi;
  angle.error = detail::inflate(angle.error + std::fabs(rest.lo));
  return turns;
}
inline double take_quarter_turns(RoughSeries& angle) {
  const double turns = quarter_turns_in(angle.c[0]);
  angle.c[0] -= 90 * turns;
  return turns;
}

}  // namespace taut::internal
