// Numbers of the library as exact fractions, by their bits alone.
#pragma once

#include <gmpxx.h>

#include <cstdlib>

#include "numeric/wide_float.hpp"

namespace taut::testing {
using namespace internal;

using Fraction = mpq_class;

inline Fraction fraction_of_two(long e) {
  mpz_class power = 1;
  power <<= static_cast<unsigned long>(std::abs(e));
  return e < 0 ? Fraction(mpz_class(1), power) : Fraction(power);
}

inline Fraction exact_fraction(double x) { return Fraction(x); }
/// Requires that it is defined.
template <unsigned Bits>
Fraction exact_fraction(const WideFloat<Bits>& x) {
  if (x.is_zero()) return 0;
  mpz_class mantissa;
  mpz_import(mantissa.get_mpz_t(), x.mantissa().size(), -1, sizeof(std::uint64_t), 0, 0, x.mantissa().data());
  const Fraction size = mantissa * fraction_of_two(x.exponent() - static_cast<long>(Bits) + 1);
  return x.is_negative() ? Fraction(-size) : size;
}

}  // namespace taut::testing
