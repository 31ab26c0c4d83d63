// Numbers of a fixed length, in exact rational numbers: what is in the operands gives what is in the result.
#include "numeric/fixed.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "numeric/short_sum.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

mpq_class rational_of(const Fixed& x) {
  mpq_class sum = 0;
  x.each_part([&sum](double part) { sum += mpq_class(part); });
  return sum;
}

/// From below the last place to near the end of the range; often with runs of zeros or ones in between.
double double_for_fixed(Rng& rng) {
  if (rng.chance(0.05)) return 0;
  double x = rng.chance(0.3) ? rng.between(1, 9) : 1 + rng.unit();
  if (rng.chance(0.2)) x = 2 - std::ldexp(x, -50);
  const int choice = rng.below(8);
  const int exponent = choice < 4 ? rng.between(-4, 4) : choice < 7 ? rng.between(-260, 20) : rng.between(-1040, 58);
  return rng.sign() * std::ldexp(x, exponent);
}

/// A ball and a number that is in it.
struct Known {
  FixedBall ball;
  mpq_class number;

  static Known of(Rng& rng) {
    const double x = double_for_fixed(rng);
    Known k{FixedBall::exact(x), mpq_class(x)};
    while (rng.chance(0.6)) {
      const double y = double_for_fixed(rng);
      k = {k.ball + FixedBall::exact(y), k.number + mpq_class(y)};
    }
    if (rng.chance(0.3)) {
      const double by = std::fabs(double_for_fixed(rng));
      k.ball.widen(by);
      k.number += mpq_class(by) * mpq_class(rng.between(-1000, 1000), 1000);
    }
    return k;
  }
  bool is_anything() const { return !(ball.rad() < INFINITY); }
};

Known scaled(const Known& k, int by) {
  mpq_class number = k.number;
  if (by < 0) mpq_div_2exp(number.get_mpq_t(), number.get_mpq_t(), static_cast<mp_bitcnt_t>(-by));
  if (by > 0) mpq_mul_2exp(number.get_mpq_t(), number.get_mpq_t(), static_cast<mp_bitcnt_t>(by));
  return {k.ball.scaled(by), number};
}

void expect_known(const Known& k) {
  if (k.is_anything()) return;
  const mpq_class mid = rational_of(k.ball.mid()), rad(k.ball.rad()), most(k.ball.most());
  EXPECT_LE(abs(k.number - mid), rad);
  EXPECT_LE(abs(k.number), most);
  EXPECT_LE(abs(k.number), mpq_class(k.ball.tightened().most()));
  EXPECT_LE(abs(k.number - mpq_class(k.ball.about())), mpq_class(k.ball.error_of(k.ball.about())));
  const int sign = k.ball.sign();
  EXPECT_TRUE(sign == 0 || sign == sgn(k.number));
}

TEST(Fixed, ResultsAreInTheirBalls) {
  Rng rng(11);
  int beyond = 0;
  for (std::uint64_t round = 0; round < effort(200000); ++round) {
    const Known a = Known::of(rng), b = Known::of(rng);
    const Known results[] = {a,
                             {-a.ball, -a.number},
                             scaled(a, rng.between(-400, 400)),
                             {a.ball + b.ball, a.number + b.number},
                             {a.ball - b.ball, a.number - b.number},
                             {a.ball * b.ball, a.number * b.number}};
    for (const Known& k : results) {
      expect_known(k);
      beyond += k.is_anything();
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(beyond, 0);  // what leaves the range says so
}

TEST(Fixed, SumsOfDoublesAreTheSameNumber) {
  Rng rng(12);
  for (std::uint64_t round = 0; round < effort(50000); ++round) {
    const Fixed x = Fixed(double_for_fixed(rng)) + Fixed(double_for_fixed(rng)) * Fixed(double_for_fixed(rng));
    const ShortSum sum(x);
    mpq_class total = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      total += mpq_class(sum.part(i));
      if (i > 0) {
        EXPECT_LT(std::fabs(sum.part(i - 1)), std::fabs(sum.part(i)));
      }
    }
    // An integer of units, as the number is.
    mpq_class scaled = total;
    mpz_mul_2exp(scaled.get_num_mpz_t(), scaled.get_num_mpz_t(), Fixed::fraction_bits);
    scaled.canonicalize();
    EXPECT_EQ(scaled.get_den(), 1);
    EXPECT_EQ(total, rational_of(x));
    EXPECT_LE(mpq_class(sum.floor()), total);
    EXPECT_GE(mpq_class(sum.ceiling()), total);
  }
}

template <class Real>
void expect_conversion(Rng& rng) {
  Real x(double_for_fixed(rng));
  for (int k = 0; k < 4; ++k) x += ldexp(x, -rng.between(50, 90)) * Real(rng.real(-1, 1));
  const Ball<Real> ball(x, rng.chance(0.5) ? 0 : std::ldexp(1, -rng.between(100, 300)));
  const FixedBall fixed = FixedBall::of(ball);
  if (!(fixed.rad() < INFINITY)) return;
  const Real off = abs(x - Real(RealMax(ShortSum(fixed.mid()).real())));
  EXPECT_LE(off + Real(ball.rad), Real(fixed.rad()) * (1 + 0x1p-40));
}

TEST(Fixed, TakesFloatingNumbers) {
  Rng rng(13);
  for (std::uint64_t round = 0; round < effort(20000); ++round) {
    expect_conversion<Real320>(rng);
    expect_conversion<Real960>(rng);
  }
}

}  // namespace
}  // namespace taut::testing
