// Sums of doubles as a number type, for formulas that are generic in the kind of number.
#pragma once

#include <array>

#include "numeric/dyadic.hpp"
#include "numeric/exact_sum.hpp"

namespace taut::internal {

/// A sum of doubles. Nothing is rounded. A result that would need more range than doubles have, or more terms than
/// there is room for, is marked as inexact, and so is everything computed from it. The capacity suffices for the
/// orientation of three vertices with four doubles for each coordinate.
class ExactNumber {
 public:
  static constexpr std::size_t capacity = 96;
  using Sum = ExactSum<capacity>;

  ExactNumber() = default;
  ExactNumber(const ExactNumber& o) : exact_(o.exact_) { sum_.assign(o.sum_, 1); }
  ExactNumber& operator=(const ExactNumber& o) {
    exact_ = o.exact_;
    sum_.assign(o.sum_, 1);
    return *this;
  }
  static ExactNumber exact(double x) {
    ExactNumber n;
    n.sum_.add(x);
    return n;
  }

  static ExactNumber of(const Dyadic& x) {
    ExactNumber n;
    for (Dyadic rest = x; !rest.is_zero() && n.exact_;) {
      const double part = nearest_double(rest);
      n.add(part);
      n.exact_ = n.exact_ && std::fabs(part) > 0x1p-900;
      rest = rest - Dyadic::exact(part);
    }
    return n;
  }

  /// Was every operation exact? If not, no other member may be used.
  bool is_exact() const { return exact_; }
  bool is_zero() const { return sum_.is_zero(); }
  const Sum& sum() const { return sum_; }

  friend ExactNumber operator-(const ExactNumber& a) {
    ExactNumber n;
    n.exact_ = a.exact_;
    n.sum_.assign(a.sum_, -1);
    return n;
  }
  friend ExactNumber operator+(ExactNumber a, const ExactNumber& b) {
    a.add(b, 1);
    return a;
  }
  friend ExactNumber operator-(ExactNumber a, const ExactNumber& b) {
    a.add(b, -1);
    return a;
  }
  /// The products a x b and a . b, in one sum.
  friend ExactNumber cross(const ExactNumber& ax, const ExactNumber& ay, const ExactNumber& bx, const ExactNumber& by) {
    return of_products(ax, by, ay, bx, -1);
  }
  friend ExactNumber dot(const ExactNumber& ax, const ExactNumber& ay, const ExactNumber& bx, const ExactNumber& by) {
    return of_products(ax, bx, ay, by, 1);
  }

 private:
  void add(const ExactNumber& b, double sign) {
    exact_ = exact_ && b.exact_;
    for (std::size_t i = 0; i < b.sum_.size(); ++i) add(sign * b.sum_.term(i));
  }
  void add(double x) {
    exact_ = exact_ && sum_.size() < capacity;
    if (exact_) sum_.add(x);
  }
  void add_product(const ExactNumber& a, const ExactNumber& b, double sign) {
    exact_ = exact_ && a.exact_ && b.exact_;
    for (std::size_t i = 0; i < a.sum_.size(); ++i) {
      for (std::size_t k = 0; k < b.sum_.size(); ++k) {
        exact_ =
            exact_ && sum_.size() + 2 <= capacity && add_exact_product(sum_, a.sum_.term(i), sign * b.sum_.term(k));
      }
    }
  }
  /// The sum a b + sign c d.
  static ExactNumber of_products(const ExactNumber& a, const ExactNumber& b, const ExactNumber& c, const ExactNumber& d,
                                 double sign) {
    ExactNumber n;
    n.add_product(a, b, 1);
    n.add_product(c, d, sign);
    return n;
  }

  Sum sum_;
  bool exact_ = true;
};

}  // namespace taut::internal
