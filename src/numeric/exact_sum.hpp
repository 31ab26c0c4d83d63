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

}  // namespace taut::internal
