// Where a function with a bounded second derivative certainly keeps, or has certainly lost, its sign.
#pragma once

#include <cmath>

namespace taut {

/// The largest h <= limit such that a + b h + c h^2/2 > 0 on (0, h) is certain (a > 0, or a = 0 and b > 0). 0 if b or c
/// is unknown (an infinite or undefined bound): every comparison below is written so that a NaN lands there.
inline double positive_until(double a, double b, double c, double limit) {
  if (b >= 0 && c >= 0) return limit;
  const double square = b * b, product = 2 * a * c;
  if (b > 0) {
    // Up and down again: both terms of the root are positive.
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

/// Some h such that a + b h + c h^2/2 <= 0 is certain there, close to the first root; infinity if there may be none.
inline double negative_from(double a, double b, double c) {
  const double square = b * b, product = 2 * a * c;
  const double discriminant = (square - product) - 0x1p-50 * (square + std::fabs(product));
  if (!(discriminant > 0)) return INFINITY;
  const double below_line = std::sqrt(discriminant) - b;
  if (!(below_line > 0)) return INFINITY;
  return 2 * a / below_line * (1 + 0x1p-47);
}

}  // namespace taut
