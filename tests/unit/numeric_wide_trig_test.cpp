// Sine and cosine of numbers with several words, against MPFR: what it says is in the balls, and they are small.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>

#include "numeric/trig.hpp"
#include "support/fraction.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A number of MPFR's, far longer than those that are judged.
class Long {
 public:
  Long() { mpfr_init2(x_, 4000); }
  explicit Long(const Fraction& exactly) : Long() { mpfr_set_q(x_, exactly.get_mpq_t(), MPFR_RNDN); }
  Long(const Long&) = delete;
  Long& operator=(const Long&) = delete;
  ~Long() { mpfr_clear(x_); }

  mpfr_ptr get() { return x_; }
  Fraction fraction() {
    mpq_class q;
    mpfr_get_q(q.get_mpq_t(), x_);
    return Fraction(q);
  }

 private:
  mpfr_t x_;
};

template <class Real>
void expect_right(const Ball<Real>& angle, double share) {
  const double unit = std::ldexp(1.0, 1 - RealTraits<Real>::bits);
  // A number of the ball: its middle, or beside it.
  Long at(exact_fraction(angle.mid) + exact_fraction(angle.rad) * exact_fraction(share)), sine, cosine;
  mpfr_sin_cos(sine.get(), cosine.get(), at.get(), MPFR_RNDN);
  const SinCos<Real> got = sin_cos(angle);
  const auto expect_near = [&](const Ball<Real>& ball, const Fraction& want) {
    EXPECT_LE(Fraction(abs(exact_fraction(ball.mid) - want)), exact_fraction(ball.rad) + fraction_of_two(-3500));
    // Large angles lose the digits that their quarter turns take.
    const double turned = std::fabs(angle.mid.to_double()) < 0.7 ? 0 : 8 * std::fabs(angle.mid.to_double());
    EXPECT_LE(ball.rad, angle.rad * 1.001 + unit * (4 + turned));
  };
  expect_near(got.sin, sine.fraction());
  expect_near(got.cos, cosine.fraction());
}

template <class Real>
void expect_right_everywhere() {
  Rng rng(7);
  const Real quarter = ldexp(pi<Real>(), -1);
  for (int round = 0; round < 1500 && !::testing::Test::HasFailure(); ++round) {
    Real x = rng.real(-4, 4);
    switch (round % 6) {
      case 1:  // all digits in use
        x = x / Real(7);
        break;
      case 2:
        x = Real(rng.real(-1, 1)) * Real(std::ldexp(1.0, rng.between(0, 59)));
        break;
      case 3:  // beside quarter turns
        x = quarter * Real(rng.between(-40, 40)) + Real(rng.sign() * std::ldexp(1.0, rng.between(-1000, -1)));
        break;
      case 4:  // between them, where the number of quarter turns is as good as either
        x = ldexp(quarter, -1) * Real(2 * rng.between(-40, 40) + 1) +
            Real(std::ldexp(rng.real(-1, 1), -rng.between(1, 80)));
        break;
      case 5:  // words of zeros, and of ones
        x = Real(std::ldexp(1.0, -rng.between(0, 300))) - Real(std::ldexp(1.0, -rng.between(300, 900)));
        break;
      default:
        break;
    }
    expect_right(Ball<Real>(x, 0.0), 0);
    expect_right(Ball<Real>(x, std::ldexp(1.0, -rng.between(1, 400))), rng.chance(0.5) ? 1 : rng.real(-1, 1));
  }
}

TEST(WideTrig, Of320BitsAgainstMpfr) { expect_right_everywhere<Real320>(); }
TEST(WideTrig, Of960BitsAgainstMpfr) { expect_right_everywhere<Real960>(); }

/// The digits of a small sine are counted from its first one.
TEST(WideTrig, SmallAnglesKeepTheirDigits) {
  for (const int exponent : {-20, -64, -200, -500, -900}) {
    const Real320 x = Real320(std::ldexp(1.0, exponent)) / Real320(3);
    const SinCos<Real320> got = sin_cos(Ball<Real320>(x, 0.0));
    Long at(exact_fraction(x)), sine;
    mpfr_sin(sine.get(), at.get(), MPFR_RNDN);
    EXPECT_LE(Fraction(abs(exact_fraction(got.sin.mid) - sine.fraction())), exact_fraction(got.sin.rad));
    EXPECT_LE(got.sin.rad, std::ldexp(1.0, std::max(exponent - 315, -990)));
  }
}

TEST(WideTrig, OfZeroExactly) {
  const SinCos<Real960> zero = sin_cos(Ball<Real960>::exact(0));
  EXPECT_TRUE(zero.sin.mid.is_zero());
  EXPECT_EQ(zero.sin.rad, 0);
  EXPECT_EQ(zero.cos.mid, Real960(1));
  EXPECT_EQ(zero.cos.rad, 0);
}

TEST(WideTrig, NothingIsClaimedBeyondItsRange) {
  for (const double x : {0x1p61, HUGE_VAL}) {
    const SinCos<Real320> got = sin_cos(Ball<Real320>::exact(x));
    EXPECT_EQ(got.sin.sign(), 0);
    EXPECT_EQ(got.cos.sign(), 0);
    EXPECT_GE(got.sin.rad, 1);
  }
}

}  // namespace
}  // namespace taut::testing
