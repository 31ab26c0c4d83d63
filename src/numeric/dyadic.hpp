// Exact numbers of any length: integers times powers of two. For the few questions that no precision answers.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "numeric/ball.hpp"

namespace taut {

/// mantissa * 2^exponent. Sums, differences and products of doubles are exact.
class Dyadic {
 public:
  using Integer = boost::multiprecision::cpp_int;

  Dyadic() = default;
  Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}
  static Dyadic exact(double x) {
    if (x == 0) return {};
    int e = 0;
    const double fraction = std::frexp(x, &e);
    return {Integer(static_cast<std::int64_t>(fraction * 0x1p53)), e - 53};
  }

  bool is_zero() const { return mantissa_.is_zero(); }
  int sign() const { return mantissa_.sign(); }
  const Integer& mantissa() const { return mantissa_; }
  int exponent() const { return exponent_; }
  /// The mantissa for a smaller exponent.
  Integer mantissa_for(int exponent) const { return mantissa_ << static_cast<unsigned>(exponent_ - exponent); }
  Dyadic halved() const { return {mantissa_, exponent_ - 1}; }

  friend Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    const int e = std::min(a.exponent_, b.exponent_);
    return {a.mantissa_for(e) + b.mantissa_for(e), e};
  }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).is_zero(); }

 private:
  Integer mantissa_ = 0;
  int exponent_ = 0;
};

/// The first bits of the mantissa: less than a unit in the last place nearer to zero than the number, or it.
template <class Real>
Real first_bits(const Dyadic& x) {
  Dyadic::Integer size = abs(x.mantissa());
  const int length = static_cast<int>(msb(size)) + 1, dropped = std::max(0, length - RealTraits<Real>::bits);
  size >>= static_cast<unsigned>(dropped);
  typename Real::Limbs limbs{};
  export_bits(size, limbs.begin(), 64, false);
  return Real::of_limbs(limbs, x.exponent() + dropped, x.sign() < 0);
}
/// The number, rounded.
template <class Real>
Ball<Real> ball_of(const Dyadic& x) {
  if (x.is_zero()) return Ball<Real>::exact(0);
  const Real middle = first_bits<Real>(x);
  return Ball<Real>(middle, detail::inflate(2 * detail::rounding(middle)));
}

/// Coefficients, ascending, the last of which is not zero; none for zero.
using DyadicPolynomial = std::vector<Dyadic>;

void trim(DyadicPolynomial& p);
DyadicPolynomial operator-(const DyadicPolynomial& p);
DyadicPolynomial operator+(const DyadicPolynomial& p, const DyadicPolynomial& q);
DyadicPolynomial operator*(const DyadicPolynomial& p, const DyadicPolynomial& q);
/// Half of each coefficient.
DyadicPolynomial halved(const DyadicPolynomial& p);
/// p / (t - root), if p is zero there, and not everywhere.
std::optional<DyadicPolynomial> without_root(const DyadicPolynomial& p, const Dyadic& root);
/// A polynomial whose square this is, if there is one with rational coefficients.
std::optional<DyadicPolynomial> square_root(const DyadicPolynomial& p);

}  // namespace taut
