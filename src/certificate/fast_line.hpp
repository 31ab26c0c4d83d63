// The certificate function of a mixed triple on a straight translation, in doubles with error bounds: a line in time.
#pragma once

#include <algorithm>
#include <cmath>

#include "certificate/fast_function.hpp"

namespace taut::internal {

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
