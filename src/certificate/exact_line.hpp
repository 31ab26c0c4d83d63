// On a straight translation, a certificate function is a line in time whose coefficients are sums of products of input
// numbers. Its sign at any instant and the instant of its root can therefore be found without rounding. Parts and
// mechanisms drawn on a grid have many events at one instant, which only the displacements distinguish. With exact
// lines, such events cost little more than events far from each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "certificate/certificate_function.hpp"
#include "certificate/fast_function.hpp"
#include "certificate/precise_time.hpp"
#include "numeric/exact_number.hpp"

namespace taut::internal {

class ExactLine {
 public:
  /// Are the certificate functions lines on this segment?
  static bool fits(const MotionSegment& segment) { return segment.translation && segment.degree <= 1; }
  /// The displacement is included. Requires fits(segment).
  ExactLine(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function);
  /// Was every product exact? Products of numbers of extremely different sizes may underflow; then no other member may
  /// be used.
  bool exact() const { return exact_; }

  /// The sign of the rate of change in time.
  int slope_sign() const { return slope_.sign(); }
  /// The sign at every instant of the enclosure, whose ends are sums of doubles; 0 if it may change there, or is not
  /// known.
  int sign_over(const PreciseTime& t) const;
  /// The instant of the zero, to about 2^-265 of its size, or to `enough`; nothing if that is not known. Requires a
  /// nonzero slope.
  std::optional<PreciseTime> root(Stage stage, double enough = 0) const;

 private:
  static constexpr std::size_t slope_terms = 32, start_terms = ExactNumber::capacity;

  /// A sum of products that is exact except for negligible ones.
  template <std::size_t Terms>
  struct NearlyExact {
    ExactSum<Terms> sum;
    double negligible = 0, error = 0;
  };
  template <std::size_t Terms>
  void begin(NearlyExact<Terms>& value, double sign) const;
  template <std::size_t Terms>
  bool add_change(NearlyExact<Terms>& value, double time) const;

  bool exact_ = true;
  ExactSum<start_terms> start_;  ///< the value at time 0
  ExactSum<slope_terms> slope_;
  double farthest_ = 0;  ///< the largest distance from time 0 on the segment
};

// The certificate function of a mixed triple on a straight translation, in doubles with error bounds: a line in time.

/// f(t) = c + d (t - middle), where c is within `value` and d within `slope`.
struct FastLine {
  double middle;
  Bounded value, slope;

  /// Requires a segment whose frame functions at its middle are `side`.
  FastLine(const FastFunction& f, const FrameSample& side, double at)
      : middle(at), value(f.value(side)), slope(f.slope(side)) {}

  Bounded at(double t) const {
    const double h = t - middle, change = slope.value * h;
    const double rounding = 0x1p-50 * (std::fabs(value.value) + std::fabs(change));
    return {value.value + change, (value.error + slope.error * std::fabs(h)) * (1 + 0x1p-50) + rounding};
  }
  /// The sign at every instant from lo to hi; 0 if it may change there, or is not known.
  int sign_over(double lo, double hi) const {
    const int sign = sign_at(lo);
    return lo == hi || (sign != 0 && sign_at(hi) == sign) ? sign : 0;
  }
  /// Is the function times `sign`, which is positive at t, certainly positive from t to `end`?
  bool holds(int sign, double t, double end) const {
    const double steep = slope.error - sign * slope.value;
    if (steep <= 0) return true;
    const Bounded v = at(t);
    return sign * v.value - v.error > steep * (end - t) * (1 + 0x1p-50);
  }
  /// Encloses the zero if the function times `sign` certainly falls; otherwise returns false.
  bool root(int sign, double& lo, double& hi) const {
    const double fall = -sign * slope.value, flat = fall - slope.error, steep = fall + slope.error;
    if (!(flat > 0)) return false;
    const double least = sign * value.value - value.error, most = sign * value.value + value.error;
    const double first = least / (least > 0 ? steep : flat), last = most / (most > 0 ? flat : steep);
    lo = middle + first - slack(first);
    hi = middle + last + slack(last);
    return lo <= hi;  // never true of a NaN
  }

 private:
  int sign_at(double t) const {
    const Bounded v = at(t);
    return std::fabs(v.value) > v.error ? (v.value > 0 ? 1 : -1) : 0;
  }
  /// The rounding error of the few operations in middle + h.
  double slack(double h) const { return 0x1p-51 * (std::fabs(h) + std::fabs(middle + h)) + 0x1p-1060; }
};

}  // namespace taut::internal
