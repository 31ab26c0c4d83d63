#include "support/exact_polynomial.hpp"

namespace taut::testing::exact {

Poly trimmed(Poly p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

Poly poly(const std::vector<double>& coefficients) {
  Poly p;
  for (const double c : coefficients) p.emplace_back(c);
  return trimmed(std::move(p));
}

Poly operator+(const Poly& a, const Poly& b) {
  Poly r(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < r.size(); ++k) r[k] = (k < a.size() ? a[k] : 0) + (k < b.size() ? b[k] : Rational(0));
  return trimmed(std::move(r));
}

Poly operator-(const Poly& a, const Poly& b) { return a + Rational(-1) * b; }

Poly operator*(const Poly& a, const Poly& b) {
  if (a.empty() || b.empty()) return {};
  Poly r(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  return trimmed(std::move(r));
}

Poly operator*(const Rational& x, const Poly& p) {
  Poly r = p;
  for (Rational& c : r) c *= x;
  return trimmed(std::move(r));
}

Poly derivative(const Poly& p) {
  Poly r;
  for (std::size_t k = 1; k < p.size(); ++k) r.push_back(Rational(static_cast<long>(k)) * p[k]);
  return trimmed(std::move(r));
}

Rational value(const Poly& p, const Rational& t) {
  Rational v = 0;
  for (std::size_t k = p.size(); k-- > 0;) v = v * t + p[k];
  return v;
}

Poly composed(const Poly& p, const Poly& inner) {
  Poly r;
  for (std::size_t k = p.size(); k-- > 0;) r = r * inner + trimmed({p[k]});
  return r;
}

Poly divided(const Poly& p, const Rational& root) {
  Poly r(p.empty() ? 0 : p.size() - 1);
  Rational carry = 0;
  for (std::size_t k = r.size(); k-- > 0;) {
    carry = carry * root + p[k + 1];
    r[k] = carry;
  }
  return trimmed(std::move(r));
}

bool is_square(const Rational& q, Rational& root) {
  if (q < 0 || !mpz_perfect_square_p(q.get_num_mpz_t()) || !mpz_perfect_square_p(q.get_den_mpz_t())) return false;
  root = Rational(sqrt(q.get_num()), sqrt(q.get_den()));
  return true;
}

namespace {

/// The integer that makes all coefficients coprime integers.
Rational factor_of(const Poly& p) {
  mpz_class below = 1, common = 0;
  for (const Rational& c : p) below = lcm(below, c.get_den());
  for (const Rational& c : p) common = gcd(common, mpz_class(c.get_num() * (below / c.get_den())));
  Rational f(below, common == 0 ? mpz_class(1) : common);
  f.canonicalize();
  return f;
}

}  // namespace

long log_norm(const Poly& p) {
  const Rational factor = factor_of(p);
  mpz_class sum = 1;
  for (const Rational& c : p) sum += abs(mpz_class(Rational(c * factor)));
  return static_cast<long>(mpz_sizeinbase(sum.get_mpz_t(), 2));
}

long log_scale(const Poly& p) {
  const Rational factor = factor_of(p);
  return static_cast<long>(mpz_sizeinbase(factor.get_num_mpz_t(), 2)) -
         static_cast<long>(mpz_sizeinbase(factor.get_den_mpz_t(), 2)) + 1;
}

}  // namespace taut::testing::exact
