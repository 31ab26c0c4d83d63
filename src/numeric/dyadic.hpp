// Exact numbers of any length: integers times powers of two. They serve the few cases that no finite precision decides.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "numeric/ball.hpp"

namespace taut::internal {

/// mantissa * 2^exponent. Sums, differences and products of doubles are exact.
///
/// The mantissa is a Boost integer, which is visible only in dyadic.cpp: its header alone takes two seconds to compile.
/// Copies share the mantissa.
class Dyadic {
 public:
  Dyadic() = default;
  Dyadic(std::int64_t mantissa, int exponent);
  static Dyadic exact(double x);
  /// Constructs the number from the mantissa's limbs, the least significant first.
  static Dyadic of_limbs(std::span<const std::uint64_t> magnitude, bool negative, int exponent);

  bool is_zero() const { return sign_ == 0; }
  int sign() const { return sign_; }
  int exponent() const { return exponent_; }
  Dyadic halved() const;
  /// Stores the first bits of the mantissa's magnitude, as many as the limbs hold, and returns the number of dropped
  /// bits.
  int first_bits(std::span<std::uint64_t> limbs) const;

  friend Dyadic operator-(const Dyadic& a);
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).is_zero(); }

 private:
  struct Integer;
  friend std::optional<std::vector<Dyadic>> square_root(const std::vector<Dyadic>& p);
  Dyadic(Integer mantissa, int exponent);
  /// The mantissa for a smaller exponent.
  Integer mantissa_for(int exponent) const;

  std::shared_ptr<const Integer> mantissa_;  ///< null for zero
  int sign_ = 0, exponent_ = 0;
};

/// The number rounded towards zero, with an error of less than a unit in the last place. Requires a nonzero number.
template <class Real>
Real first_bits(const Dyadic& x) {
  typename Real::Limbs limbs{};
  const int dropped = x.first_bits(limbs);
  return Real::of_limbs(limbs, x.exponent() + dropped, x.sign() < 0);
}
/// A ball around the rounded number.
template <class Real>
Ball<Real> ball_of(const Dyadic& x) {
  if (x.is_zero()) return Ball<Real>::exact(0);
  const Real middle = first_bits<Real>(x);
  return Ball<Real>(middle, detail::inflate(2 * detail::rounding(middle)));
}

/// The nearest double, or one next to it; 0 if it would be infinite.
double nearest_double(const Dyadic& x);

/// Coefficients in ascending order. The last one is nonzero; the zero polynomial has none.
using DyadicPolynomial = std::vector<Dyadic>;

void trim(DyadicPolynomial& p);
DyadicPolynomial operator-(const DyadicPolynomial& p);
DyadicPolynomial operator+(const DyadicPolynomial& p, const DyadicPolynomial& q);
DyadicPolynomial operator*(const DyadicPolynomial& p, const DyadicPolynomial& q);
/// Half of each coefficient.
DyadicPolynomial halved(const DyadicPolynomial& p);
/// The coefficients of p(place + h) in powers of h.
DyadicPolynomial expanded_about(DyadicPolynomial p, const Dyadic& place);
/// p / (t - root), if p is zero there, but not identically.
std::optional<DyadicPolynomial> without_root(const DyadicPolynomial& p, const Dyadic& root);
/// A polynomial whose square is p, if there is one with rational coefficients.
std::optional<DyadicPolynomial> square_root(const DyadicPolynomial& p);

}  // namespace taut::internal
