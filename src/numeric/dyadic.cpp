#include "numeric/dyadic.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace taut::internal {

struct Dyadic::Integer {
  boost::multiprecision::cpp_int value;
};

Dyadic::Dyadic(Integer mantissa, int exponent) : sign_(mantissa.value.sign()), exponent_(exponent) {
  if (sign_ != 0) mantissa_ = std::make_shared<const Integer>(std::move(mantissa));
}
Dyadic::Dyadic(std::int64_t mantissa, int exponent) : Dyadic(Integer{mantissa}, exponent) {}

Dyadic Dyadic::exact(double x) {
  if (x == 0) return {};
  int e = 0;
  const double fraction = std::frexp(x, &e);
  return {static_cast<std::int64_t>(fraction * 0x1p53), e - 53};
}

Dyadic Dyadic::of_limbs(std::span<const std::uint64_t> magnitude, bool negative, int exponent) {
  Integer mantissa;
  import_bits(mantissa.value, magnitude.begin(), magnitude.end(), 64, false);
  if (negative) mantissa.value = -mantissa.value;
  return {std::move(mantissa), exponent};
}

Dyadic Dyadic::halved() const {
  Dyadic half = *this;
  --half.exponent_;
  return half;
}

Dyadic::Integer Dyadic::mantissa_for(int exponent) const {
  if (is_zero()) return {};
  return {mantissa_->value << static_cast<unsigned>(exponent_ - exponent)};
}

int Dyadic::first_bits(std::span<std::uint64_t> limbs) const {
  boost::multiprecision::cpp_int size = abs(mantissa_->value);
  const int length = static_cast<int>(msb(size)) + 1,
            dropped = std::max(0, length - 64 * static_cast<int>(limbs.size()));
  size >>= static_cast<unsigned>(dropped);
  export_bits(size, limbs.begin(), 64, false);
  return dropped;
}

Dyadic operator-(const Dyadic& a) {
  if (a.is_zero()) return a;
  return {Dyadic::Integer{-a.mantissa_->value}, a.exponent_};
}
Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const Dyadic& low = a.exponent_ < b.exponent_ ? a : b;
  const Dyadic& high = a.exponent_ < b.exponent_ ? b : a;
  Dyadic::Integer sum = high.mantissa_for(low.exponent_);
  sum.value += low.mantissa_->value;
  return {std::move(sum), low.exponent_};
}
Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  if (a.is_zero() || b.is_zero()) return {};
  return {Dyadic::Integer{a.mantissa_->value * b.mantissa_->value}, a.exponent_ + b.exponent_};
}

void trim(DyadicPolynomial& p) {
  while (!p.empty() && p.back().is_zero()) p.pop_back();
}

DyadicPolynomial operator-(const DyadicPolynomial& p) {
  DyadicPolynomial out;
  for (const Dyadic& c : p) out.push_back(-c);
  return out;
}

DyadicPolynomial operator+(const DyadicPolynomial& p, const DyadicPolynomial& q) {
  DyadicPolynomial sum = p.size() > q.size() ? p : q;
  const DyadicPolynomial& other = p.size() > q.size() ? q : p;
  for (std::size_t k = 0; k < other.size(); ++k) sum[k] = sum[k] + other[k];
  trim(sum);
  return sum;
}

DyadicPolynomial operator*(const DyadicPolynomial& p, const DyadicPolynomial& q) {
  if (p.empty() || q.empty()) return {};
  DyadicPolynomial product(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t k = 0; k < q.size(); ++k) product[i + k] = product[i + k] + p[i] * q[k];
  }
  return product;
}

DyadicPolynomial halved(const DyadicPolynomial& p) {
  DyadicPolynomial out;
  for (const Dyadic& c : p) out.push_back(c.halved());
  return out;
}

double nearest_double(const Dyadic& x) {
  if (x.is_zero()) return 0;
  const double nearest = RealTraits<RealMax>::to_double(first_bits<RealMax>(x));
  return std::isfinite(nearest) ? nearest : 0;
}

DyadicPolynomial expanded_about(DyadicPolynomial p, const Dyadic& place) {
  if (place.is_zero()) return p;
  for (std::size_t k = 0; k + 1 < p.size(); ++k) {
    for (std::size_t i = p.size() - 1; i-- > k;) p[i] = p[i] + p[i + 1] * place;
  }
  return p;
}

/// Uses Horner's scheme from the highest power down. The remainder is the value at the root.
std::optional<DyadicPolynomial> without_root(const DyadicPolynomial& p, const Dyadic& root) {
  if (p.empty()) return std::nullopt;
  DyadicPolynomial quotient(p.size() - 1);
  Dyadic carried;
  for (std::size_t k = p.size(); k-- > 0;) {
    carried = p[k] + root * carried;
    if (k > 0) quotient[k - 1] = carried;
  }
  if (!carried.is_zero()) return std::nullopt;
  return quotient;
}

/// A square root of a polynomial with integer coefficients has integer coefficients, too (Gauss). They are computed
/// from the highest power down.
std::optional<DyadicPolynomial> square_root(const DyadicPolynomial& p) {
  if (p.empty()) return DyadicPolynomial();
  if (p.size() % 2 == 0 || p.back().sign() < 0) return std::nullopt;
  int e = p[0].exponent();
  for (const Dyadic& c : p) e = std::min(e, c.is_zero() ? e : c.exponent());
  if (e % 2 != 0) --e;
  using Integer = boost::multiprecision::cpp_int;
  const std::size_t degree = (p.size() - 1) / 2;
  const Integer lead = p.back().mantissa_for(e).value;
  std::vector<Integer> root(degree + 1);
  root[degree] = boost::multiprecision::sqrt(lead);
  if (root[degree] * root[degree] != lead) return std::nullopt;
  const Integer twice = root[degree] * 2;
  for (std::size_t k = degree; k-- > 0;) {
    Integer rest = p[degree + k].mantissa_for(e).value;
    for (std::size_t i = k + 1; i < degree; ++i) rest -= root[i] * root[degree + k - i];
    if (rest % twice != 0) return std::nullopt;
    root[k] = rest / twice;
  }
  DyadicPolynomial result;
  for (const Integer& c : root) result.push_back(Dyadic(Dyadic::Integer{c}, e / 2));
  return result * result + -p == DyadicPolynomial() ? std::optional(result) : std::nullopt;
}

}  // namespace taut::internal
