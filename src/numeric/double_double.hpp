// Sums of two doubles that record whether anything was rounded.
#pragma once

#include <cmath>

#include "numeric/exact_sum.hpp"

namespace taut::internal {

/// A number as the sum of two doubles (Dekker 1971), to about 2^-104 relatively, with a bound of its error. Coordinates
/// drawn on a grid have few digits, and so have their differences and products. In that case nothing is rounded, and
/// the bound is exactly zero. A zero with that bound is certainly zero.
class DoubleDouble {
 public:
  DoubleDouble() = default;
  static DoubleDouble exact(double x) { return {x, 0, 0}; }

  /// A double within a unit in the last place of the sum, the remainder, and a bound of the error of both together.
  double leading() const { return hi_; }
  double rest() const { return lo_; }
  double error() const { return error_; }
  /// A bound of its magnitude.
  double most() const { return (std::fabs(hi_) + std::fabs(lo_) + error_) * up; }

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi_, -a.lo_, a.error_}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const TwoDoubles high = two_sum(a.hi_, b.hi_), low = two_sum(a.lo_, b.lo_);
    const TwoDoubles middle = two_sum(high.lo, low.hi);
    const TwoDoubles first = two_sum(high.hi, middle.hi);
    const TwoDoubles rest = two_sum(middle.lo, low.lo);
    const TwoDoubles second = two_sum(first.lo, rest.hi);
    const TwoDoubles sum = two_sum(first.hi, second.hi);
    return {sum.hi, sum.lo, (a.error_ + b.error_ + (std::fabs(second.lo) + std::fabs(rest.lo))) * up};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    double lost = 0;
    const TwoDoubles high = product(a.hi_, b.hi_, lost);
    if (a.lo_ == 0 && b.lo_ == 0 && a.error_ == 0 && b.error_ == 0) return {high.hi, high.lo, lost};
    const TwoDoubles one = product(a.hi_, b.lo_, lost), other = product(a.lo_, b.hi_, lost);
    const TwoDoubles cross = two_sum(one.hi, other.hi), low = two_sum(high.lo, cross.hi);
    const TwoDoubles product = two_sum(high.hi, low.hi);
    lost += (std::fabs(low.lo) + std::fabs(cross.lo)) + (std::fabs(one.lo) + std::fabs(other.lo));
    // These products may underflow themselves.
    if (a.lo_ != 0 && b.lo_ != 0) lost += std::fabs(a.lo_ * b.lo_) + underflow;
    if (a.error_ != 0 || b.error_ != 0) lost += a.error_ * b.most() + b.error_ * a.most() + underflow;
    return {product.hi, product.lo, lost * up};
  }

 private:
  /// Bounds of the rounding in sums of a few positive terms, and of the loss in products that nearly underflow.
  static constexpr double up = 1 + 0x1p-49, underflow = 0x1p-900;

  DoubleDouble(double hi, double lo, double error) : hi_(hi), lo_(lo), error_(error) {}
  /// The product. Adds to `lost` the loss where the exact product has no room; an overflow gives a NaN.
  static TwoDoubles product(double a, double b, double& lost) {
    if (a == 0 || b == 0) return {0, 0};
    const TwoDoubles p = two_product(a, b);
    if (!(std::fabs(p.hi) > 0x1p-950)) lost += underflow;
    return p;
  }

  double hi_ = 0, lo_ = 0, error_ = 0;
};

}  // namespace taut::internal
