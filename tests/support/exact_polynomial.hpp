// Polynomials with rational coefficients, real and complex.
#pragma once

#include <vector>

#include "support/exact_interval.hpp"

namespace taut::testing::exact {

/// Ascending powers; no zeros at the end, so that zero is empty and equal polynomials compare equal.
using Poly = std::vector<Rational>;

Poly trimmed(Poly p);
Poly poly(const std::vector<double>& coefficients);
Poly operator+(const Poly& a, const Poly& b);
Poly operator-(const Poly& a, const Poly& b);
Poly operator*(const Poly& a, const Poly& b);
Poly operator*(const Rational& x, const Poly& p);
Poly derivative(const Poly& p);
Rational value(const Poly& p, const Rational& t);
/// p(inner(u)).
Poly composed(const Poly& p, const Poly& inner);
/// p / (t - root), which must divide it.
Poly divided(const Poly& p, const Rational& root);
/// Is it the square of a rational number? Then that number, not negative.
bool is_square(const Rational& q, Rational& root);

/// log2, rounded up, of the sum of the magnitudes of the coefficients after they are made coprime integers.
long log_norm(const Poly& p);
/// The same factor's log2: integers = coefficients * 2^that, roughly, from above.
long log_scale(const Poly& p);

/// re + i im.
struct Complex {
  Poly re, im;
  bool zero() const { return re.empty() && im.empty(); }
};
inline Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator*(const Complex& a, const Complex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Complex conj(const Complex& a) { return {a.re, Rational(-1) * a.im}; }

}  // namespace taut::testing::exact
