// Functions of a few parameters over a box: linear ones, with a bound of the rest.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/degrees.hpp"

namespace taut::internal {

/// For all h with |h[k]| <= 1, the function is within `error` of value + sum rate[k] h[k]. What several parts have of
/// one parameter cancels, as in the angle of a link that turns back on one that turns.
class BoxModel {
 public:
  using Number = double;
  static constexpr std::size_t parameters = 4;

  static BoxModel constant(double x) { return constant(Ball<double>::exact(x)); }
  static BoxModel constant(const Ball<double>& x) {
    BoxModel m;
    m.value = x.mid;
    m.error = x.rad;
    return m;
  }

  double value = 0, error = 0;
  std::array<double, parameters> rate{};

  /// Bounds the magnitudes of the linear part, and of the whole.
  double swing() const {
    double sum = 0;
    for (const double r : rate) sum += std::fabs(r);
    return sum * (1 + 0x1p-45);
  }
  double magnitude() const { return (std::fabs(value) + swing() + error) * (1 + 0x1p-45); }

  friend BoxModel operator-(BoxModel a) {
    a.value = -a.value;
    for (double& r : a.rate) r = -r;
    return a;
  }
  friend BoxModel operator+(const BoxModel& a, const BoxModel& b) { return sum(a, b, 1); }
  friend BoxModel operator-(const BoxModel& a, const BoxModel& b) { return sum(a, b, -1); }
  friend BoxModel operator*(const BoxModel& a, const BoxModel& b) {
    BoxModel m;
    m.value = a.value * b.value;
    for (std::size_t k = 0; k < parameters; ++k) m.rate[k] = a.value * b.rate[k] + a.rate[k] * b.value;
    const double sa = a.swing(), sb = b.swing(), na = std::fabs(a.value) + sa, nb = std::fabs(b.value) + sb;
    // Each rate is a sum of two products.
    m.error = rounded_up(sa * sb + na * b.error + nb * a.error + a.error * b.error + 0x1p-51 * na * nb);
    return m;
  }
  friend BoxModel operator*(const BoxModel& a, const Ball<double>& b) {
    BoxModel m = a;
    m.value *= b.mid;
    for (double& r : m.rate) r *= b.mid;
    m.error = rounded_up((std::fabs(a.value) + a.swing()) * (b.rad + 0x1p-52 * std::fabs(b.mid)) +
                         a.error * (std::fabs(b.mid) + b.rad));
    return m;
  }
  /// By Taylor's theorem: second derivatives are at most 1.
  friend void sin_cos(const BoxModel& a, BoxModel& sine, BoxModel& cosine) {
    const SinCos<double> at = sin_cos(Ball<double>::exact(a.value));
    const double swing = a.swing(), most = swing + a.error;
    sine = constant(at.sin.mid);
    cosine = constant(at.cos.mid);
    for (std::size_t k = 0; k < parameters; ++k) {
      sine.rate[k] = at.cos.mid * a.rate[k];
      cosine.rate[k] = -at.sin.mid * a.rate[k];
    }
    const double rounding = (at.sin.rad + at.cos.rad) * (1 + most) + 0x1p-52 * swing;
    sine.error = rounded_up(std::fabs(at.cos.mid) * a.error + most * most / 2 + rounding);
    cosine.error = rounded_up(std::fabs(at.sin.mid) * a.error + most * most / 2 + rounding);
  }

 private:
  static double rounded_up(double x) { return x * (1 + 0x1p-40) + underflow_slack; }
  static BoxModel sum(const BoxModel& a, const BoxModel& b, double sign) {
    BoxModel m;
    m.value = a.value + sign * b.value;
    for (std::size_t k = 0; k < parameters; ++k) m.rate[k] = a.rate[k] + sign * b.rate[k];
    m.error = rounded_up(a.error + b.error + 0x1p-53 * (std::fabs(m.value) + m.swing()));
    return m;
  }
};

inline double take_quarter_turns(BoxModel& angle) {
  const double turns = quarter_turns_in(angle.value);
  const TwoDoubles rest = two_sum(angle.value, -90 * turns);
  angle.value = rest.hi;
  angle.error = detail::inflate(angle.error + std::fabs(rest.lo));
  return turns;
}

}  // namespace taut::internal
