#include "numeric/dyadic.hpp"

#include <algorithm>

namespace taut {

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

/// By Horner's scheme, from the highest power down: what is left at the end is the value.
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

/// With integer coefficients a root has integer coefficients, too (Gauss): found from the highest power down.
std::optional<DyadicPolynomial> square_root(const DyadicPolynomial& p) {
  if (p.empty()) return DyadicPolynomial();
  if (p.size() % 2 == 0 || p.back().sign() < 0) return std::nullopt;
  int e = p[0].exponent();
  for (const Dyadic& c : p) e = std::min(e, c.is_zero() ? e : c.exponent());
  if (e % 2 != 0) --e;
  using Integer = Dyadic::Integer;
  const std::size_t degree = (p.size() - 1) / 2;
  const Integer lead = p.back().mantissa_for(e);
  std::vector<Integer> root(degree + 1);
  root[degree] = boost::multiprecision::sqrt(lead);
  if (root[degree] * root[degree] != lead) return std::nullopt;
  const Integer twice = root[degree] * 2;
  for (std::size_t k = degree; k-- > 0;) {
    Integer rest = p[degree + k].is_zero() ? Integer(0) : p[degree + k].mantissa_for(e);
    for (std::size_t i = k + 1; i < degree; ++i) rest -= root[i] * root[degree + k - i];
    if (rest % twice != 0) return std::nullopt;
    root[k] = rest / twice;
  }
  DyadicPolynomial result;
  for (const Integer& c : root) result.emplace_back(c, e / 2);
  return result * result + -p == DyadicPolynomial() ? std::optional(result) : std::nullopt;
}

}  // namespace taut
