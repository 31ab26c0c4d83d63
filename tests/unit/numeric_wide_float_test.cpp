// Number numbers against exact fractions, which share nothing with them: what operations round, and what they do not.
#include "numeric/wide_float.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>

#include "numeric/trig.hpp"
#include "support/effort.hpp"
#include "support/fraction.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// Words at random, of zeros, or of ones only: roundings that carry through all of them, sums that cancel, ties.
template <class Number>
Number any_wide(Rng& rng) {
  typename Number::Limbs words{};
  const int kind = rng.below(4);
  for (std::uint64_t& word : words) {
    const int pattern = kind == 0 ? 2 : rng.below(4);
    word = pattern == 0 ? 0 : pattern == 1 ? ~std::uint64_t{0} : rng.next();
  }
  if (kind == 1) words = {};
  words[words.size() - 1] = rng.chance(0.2) ? std::uint64_t{1} << rng.below(64) : rng.next();
  const int bits = 64 * static_cast<int>(words.size());
  const int away = rng.chance(0.7) ? rng.between(-4, 4) : rng.between(-bits - 80, bits + 80);
  return Number::of_limbs(words, away - bits, rng.chance(0.5));
}

/// Another one that is close to it, so that nearly all cancels.
template <class Number>
Number beside(Rng& rng, const Number& x) {
  return x + ldexp(any_wide<Number>(rng), -rng.below(64 * static_cast<int>(Number::limbs) + 4));
}

/// A unit in the last place.
template <unsigned Bits>
Fraction unit_of(const WideFloat<Bits>& x) {
  return fraction_of_two(x.exponent() - static_cast<long>(Bits) + 1);
}

/// Is it the nearest number, up to a share of a unit?
template <class Number>
void expect_rounded(const Number& got, const Fraction& exact, const Fraction& share, const char* what) {
  ASSERT_TRUE(got.is_defined()) << what;
  const Fraction error = abs(Fraction(exact_fraction(got) - exact));
  if (error == 0) return;
  ASSERT_FALSE(got.is_zero()) << what;
  EXPECT_LE(error, unit_of(got) * (Fraction(1, 2) + share)) << what;
  if (share == 0 && error * 2 == unit_of(got)) {
    EXPECT_EQ(got.mantissa()[0] & 1, 0u) << what << ": ties go to the even one";
  }
}

template <class Number>
void expect_operations(std::uint64_t rounds) {
  Rng rng(Number::limbs);
  const Fraction exactly = 0, nearly = fraction_of_two(-50);
  for (std::uint64_t i = 0; i < effort(rounds); ++i) {
    const Number a = any_wide<Number>(rng), b = rng.chance(0.2) ? -beside(rng, a) : any_wide<Number>(rng);
    if (a.is_zero() || b.is_zero()) continue;
    const Fraction x = exact_fraction(a), y = exact_fraction(b);
    expect_rounded(a + b, x + y, exactly, "a sum");
    expect_rounded(a - b, x - y, exactly, "a difference");
    expect_rounded(a * b, x * y, nearly, "a product");
    expect_rounded(a / b, x / y, exactly, "a quotient");
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(a > b, x > y);
    EXPECT_EQ(a == b, x == y);
    // A root is within (1/2 + share) units: squares on both sides tell, with no root taken.
    const Number root = sqrt(abs(a));
    const Fraction r = exact_fraction(root), reach = unit_of(root) * (Fraction(1, 2) + nearly), size = abs(x);
    EXPECT_LE((r - reach) * (r - reach), size);
    EXPECT_GE((r + reach) * (r + reach), size);
  }
}

TEST(WideFloat, RoundsToNearestAt192Bits) { expect_operations<WideFloat<192>>(4000); }
TEST(WideFloat, RoundsToNearestAt320Bits) { expect_operations<WideFloat<320>>(4000); }
TEST(WideFloat, RoundsToNearestAt960Bits) { expect_operations<WideFloat<960>>(2000); }

/// What is a number of this length comes out exactly: products, quotients and roots of shorter ones.
TEST(WideFloat, IsExactWhereItCanBe) {
  using Half = WideFloat<320>;
  using Number = WideFloat<960>;
  Rng rng(1);
  for (std::uint64_t i = 0; i < effort(4000); ++i) {
    const Number a(any_wide<Half>(rng)), b(any_wide<Half>(rng));
    if (a.is_zero() || b.is_zero()) continue;
    const Number product = a * b;
    EXPECT_EQ(exact_fraction(product), exact_fraction(a) * exact_fraction(b));
    EXPECT_EQ(product / b, a);
    EXPECT_EQ(sqrt(a * a), abs(a));
  }
}

/// Doubles, the smallest ones, too; and what is rounded to them.
TEST(WideFloat, ConvertsDoubles) {
  Rng rng(2);
  for (std::uint64_t i = 0; i < effort(20000); ++i) {
    const double x = rng.sign() * std::ldexp(1 + rng.unit(), rng.between(-1074, 1022));
    EXPECT_EQ(exact_fraction(Real320(x)), Fraction(x));
    EXPECT_EQ(Real320(x).to_double(), x);
    // mpfr rounds to the nearest double, among those below the normal ones, too.
    const Real320 wide = ldexp(any_wide<Real320>(rng), rng.chance(0.5) ? 0 : rng.between(-1090, -1000));
    mpfr_t exact;
    mpfr_init2(exact, 320);
    mpfr_set_q(exact, exact_fraction(wide).get_mpq_t(), MPFR_RNDN);
    EXPECT_EQ(wide.to_double(), mpfr_get_d(exact, MPFR_RNDN));
    mpfr_clear(exact);
  }
  EXPECT_EQ(Real320(0).to_double(), 0);
  EXPECT_EQ(ldexp(Real320(1), 1024).to_double(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ldexp(Real320(-1), 900000).to_double(), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(ldexp(Real320(1), -900000).to_double(), 0);
}

TEST(WideFloat, ConvertsLengths) {
  Rng rng(3);
  for (std::uint64_t i = 0; i < effort(10000); ++i) {
    const Real960 wide = any_wide<Real960>(rng);
    if (wide.is_zero()) continue;
    expect_rounded(Real320(wide), exact_fraction(wide), 0, "320 bits");
    expect_rounded(WideFloat<192>(wide), exact_fraction(wide), 0, "192 bits");
    const Real320 narrow(wide);
    EXPECT_EQ(Real320(Real960(narrow)), narrow);
    EXPECT_EQ(exact_fraction(Real960(narrow)), exact_fraction(narrow));
  }
}

TEST(WideFloat, IsCutToItsFirstBits) {
  Rng rng(5);
  for (std::uint64_t i = 0; i < effort(10000); ++i) {
    const Real320 x = any_wide<Real320>(rng);
    const int count = rng.between(-10, 400);
    const Real320 cut = x.first_bits(count);
    if (x.is_zero()) {
      EXPECT_TRUE(cut.is_zero());
      continue;
    }
    const Fraction whole = exact_fraction(x), left = whole - exact_fraction(cut);
    EXPECT_EQ(cut.is_negative(), x.is_negative());
    EXPECT_LT(abs(left), fraction_of_two(x.exponent() + 1 - std::max(count, 1)));
    EXPECT_GE(left * whole, 0) << "towards zero";
    for (int word = 0; word < static_cast<int>(Real320::limbs) - (std::max(count, 1) + 63) / 64; ++word) {
      EXPECT_EQ(cut.mantissa()[static_cast<std::size_t>(word)], 0u);
    }
  }
}

TEST(WideFloat, KnowsIntegers) {
  Rng rng(4);
  for (std::uint64_t i = 0; i < effort(20000); ++i) {
    const auto k = static_cast<std::int64_t>(rng.next() >> rng.between(2, 63)) * rng.sign();
    const Real320 whole = Real320::of_integer(k);
    EXPECT_EQ(exact_fraction(whole), Fraction(mpz_class(std::to_string(k))));
    EXPECT_EQ(whole.nearest_integer(), k);
    const Real320 beside = whole + rng.real(-0.499, 0.499);
    EXPECT_EQ(beside.nearest_integer(), k);
    EXPECT_EQ(round(beside), whole);
    const Real320 large = ldexp(whole, 200);
    EXPECT_EQ(round(large + 0.25), large);
  }
  EXPECT_EQ(Real320(0.75).nearest_integer(), 1);
  EXPECT_EQ(Real320(-0.25).nearest_integer(), 0);
  EXPECT_EQ(Real320(0).nearest_integer(), 0);
}

/// What is not a number says so, and nothing that is made of it hides that.
TEST(WideFloat, IsUndefinedWhereNothingIs) {
  const Real320 one(1), zero(0), huge = ldexp(one, 999999);
  const Real320 infinite(std::numeric_limits<double>::infinity()), none(std::nan(""));
  for (const Real320& x : {one / zero, zero / zero, sqrt(-one), huge * huge, infinite, none}) {
    EXPECT_FALSE(x.is_defined());
    for (const Real320& y : {x + one, one - x, x * zero, one / x, zero / x, sqrt(x), -x, abs(x), ldexp(x, -5)}) {
      EXPECT_FALSE(y.is_defined());
    }
    EXPECT_FALSE(WideFloat<192>(x).is_defined());
    EXPECT_FALSE(Real320(Real960(x)).is_defined());
    EXPECT_FALSE(x < one || x > one || x == one || x == x);
    EXPECT_TRUE(std::isnan(x.to_double()));
    EXPECT_EQ(RealTraits<Real320>::magnitude(x), std::numeric_limits<double>::infinity());
  }
  EXPECT_TRUE((ldexp(one, -999999) * ldexp(one, -999999)).is_zero());
}

template <class Number>
void expect_pi() {
  mpfr_t exact;
  mpfr_init2(exact, static_cast<mpfr_prec_t>(64 * Number::limbs));
  mpfr_const_pi(exact, MPFR_RNDN);
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), exact);
  EXPECT_EQ(exact_fraction(pi<Number>()), value);
  mpfr_clear(exact);
}
TEST(WideFloat, KnowsPi) {
  expect_pi<Real320>();
  expect_pi<Real960>();
}

}  // namespace
}  // namespace taut::testing
