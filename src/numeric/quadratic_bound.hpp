// Bounds of the time for which a function with a bounded second or third derivative certainly keeps its sign, or after
// which it has certainly lost it.
#pragma once

#include <cmath>

namespace taut::internal {

inline constexpr double one_third = (1.0 / 3) * (1 + 0x1p-40);  ///< rounded up

/// The largest h <= limit such that a + b h + c h^2/2 > 0 on (0, h) is certain (a > 0, or a = 0 and b > 0). The result
/// is 0 if b or c is unknown (an infinite or undefined bound): every comparison below is written so that a NaN leads to
/// that result.
inline double positive_until(double a, double b, double c, double limit) {
  if (b >= 0 && c >= 0) return limit;
  const double square = b * b, product = 2 * a * c;
  if (b > 0) {
    // The function rises and falls again: both terms of the root are positive.
    const double discriminant = square - product;
    if (!(discriminant < INFINITY)) return 0;
    const double h = (b + std::sqrt(discriminant)) / -c * (1 - 0x1p-48);
    return h < limit ? h : (h >= limit ? limit : 0);
  }
  // The discriminant rounded up makes the root smaller.
  const double discriminant = (square - product) + 0x1p-50 * (square + std::fabs(product));
  if (discriminant < 0) return limit;
  const double below_line = std::sqrt(discriminant) - b;
  if (!(below_line > 0)) return 0;
  const double h = 2 * a / below_line * (1 - 0x1p-48);
  return h < limit ? h : (h >= limit ? limit : 0);
}

/// Is a + b h + c h^2/2 > 0 on (0, limit) certain? Most functions stay positive for long, and this quick test requires
/// no square root. False if anything is unknown.
inline bool positive_throughout(double a, double b, double c, double limit) {
  const double end = a + limit * (b + c * limit * 0.5);
  const double rounding = 0x1p-49 * (a + limit * (std::fabs(b) + std::fabs(c) * limit));
  // There is no minimum inside: the function is concave, or rises from the start, or falls to the end. Or the minimum
  // is not deep enough.
  const bool no_valley = (c <= 0) | (b >= 0) | (b + c * limit <= 0) | (b * b < 2 * a * c * (1 - 0x1p-49));
  return (a >= 0) & (end > rounding) & no_valley;
}

/// An approximate analogue for a + b h + c h^2/2 - d h^3/6, d >= 0. It holds up to any H for which (c - d H/3) h^2/2 is
/// a lower bound there; the nearer H, the better.
inline double positive_until(double a, double b, double c, double d, double limit) {
  if (positive_throughout(a, b, c - d * limit * one_third, limit)) return limit;
  double h = positive_until(a, b, c - d * limit * one_third, limit);
  if (!(d > 0) || !(h > 0) || h >= limit) return h;
  const double within = h + h < limit ? h + h : limit;
  const double further = positive_until(a, b, c - d * within * one_third, within);
  return further > h ? further : h;
}

/// Like positive_until(), where the sign is known up to h = `known`. Tries `step` more than that, then twice as much
/// more, and so on, `doublings` times, but no further than `most`.
inline double positive_over(double a, double b, double c, double d, double known, double step, double most,
                            int doublings) {
  for (; known < most && doublings > 0; --doublings, step *= 2) {
    const double limit = known + step < most ? known + step : most;
    const double second = c - d * limit * one_third;
    if (!positive_throughout(a, b, second, limit)) return std::fmax(known, positive_until(a, b, second, limit));
    known = limit;
  }
  return known;
}

/// Some h such that a + b h + c h^2/2 <= 0 is certain there, close to the first root; infinity if there may be none.
inline double negative_from(double a, double b, double c) {
  const double square = b * b, product = 2 * a * c;
  const double discriminant = (square - product) - 0x1p-50 * (square + std::fabs(product));
  if (!(discriminant > 0)) return INFINITY;
  const double below_line = std::sqrt(discriminant) - b;
  if (!(below_line > 0)) return INFINITY;
  return 2 * a / below_line * (1 + 0x1p-47);
}

}  // namespace taut::internal
