// Exact signs of sums of products of doubles, by error-free transformations (Dekker 1971, Knuth, Shewchuk 1997).
#pragma once

#include <cmath>
#include <cstddef>

namespace taut::internal {

struct TwoDoubles {
  double hi, lo;
};

/// hi + lo == a + b exactly, hi == fl(a + b).
inline TwoDoubles two_sum(double a, double b) {
  const double s = a + b;
  const double bv = s - a;
  const double av = s - bv;
  return {s, (a - av) + (b - bv)};
}

/// hi + lo == a * b exactly, hi == fl(a * b), barring overflow and underflow (|a b| in [2^-960, 2^960], or zero).
inline TwoDoubles two_product(double a, double b) {
  const double p = a * b;
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double ca = splitter * a, ah = ca - (ca - a), al = a - ah;
  const double cb = splitter * b, bh = cb - (cb - b), bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

/// An exact running sum of doubles and products of doubles: a nonoverlapping expansion, smallest component first.
/// Capacity is the number of additions; an addition grows the expansion by at most one component.
template <std::size_t Capacity>
class ExactSum {
 public:
  void add(double x) {
    std::size_t kept = 0;
    if constexpr (Capacity > 16) {
      // Components below half a unit in the last place of x stay unchanged. A long sum has many of them.
      const double small = 0x1p-54 * std::fabs(x);
      while (kept < size_ && std::fabs(terms_[kept]) < small) ++kept;
    }
    double carry = x;
    for (std::size_t i = kept; i < size_; ++i) {
      const TwoDoubles t = two_sum(carry, terms_[i]);
      carry = t.hi;
      if (t.lo != 0) terms_[kept++] = t.lo;
    }
    if (carry != 0) terms_[kept++] = carry;
    size_ = kept;
  }
  void add_product(double a, double b) {
    const TwoDoubles p = two_product(a, b);
    if (p.lo != 0) add(p.lo);
    add(p.hi);
  }
  void subtract_product(double a, double b) { add_product(-a, b); }

  /// Assigns sign * other, where sign is 1 or -1.
  template <std::size_t Other>
  void assign(const ExactSum<Other>& other, double sign) {
    static_assert(Other <= Capacity);
    size_ = other.size();
    for (std::size_t i = 0; i < size_; ++i) terms_[i] = sign * other.term(i);
  }

  /// Assigns a sum that is known to fit into the capacity.
  template <std::size_t Other>
  void take(const ExactSum<Other>& other) {
    size_ = other.size();
    for (std::size_t i = 0; i < size_ && i < Capacity; ++i) terms_[i] = other.term(i);
  }

  bool is_zero() const { return size_ == 0; }
  /// -1, 0 or +1: exact.
  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0 ? 1 : -1); }
  /// The sum rounded to a double (error at most one ulp).
  double approximate() const {
    double s = 0;
    for (std::size_t i = 0; i < size_; ++i) s += terms_[i];
    return s;
  }
  std::size_t size() const { return size_; }
  double term(std::size_t i) const { return terms_[i]; }

 private:
  std::size_t size_ = 0;
  double terms_[Capacity];
};

/// Adds a b. Returns false if the product is so small, or so large, that its rounding error may be lost.
template <std::size_t Capacity>
bool add_exact_product(ExactSum<Capacity>& sum, double a, double b) {
  if (a == 0 || b == 0) return true;
  const double size = std::fabs(a * b);
  if (!(size > 0x1p-900 && size < 0x1p900)) return false;
  sum.add_product(a, b);
  return true;
}

// Sums of two doubles that record whether anything was rounded.

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
