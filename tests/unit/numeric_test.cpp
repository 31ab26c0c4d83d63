// The laws of the numbers: error-free transformations, balls, trigonometry, jets, root isolation.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/exact_sum.hpp"
#include "numeric/jet.hpp"
#include "numeric/root_isolation.hpp"
#include "support/fraction.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// Magnitudes spread over many orders.
double wild(Rng& rng, double decades = 6) { return rng.sign() * std::pow(10.0, rng.real(-decades, decades)); }

template <class Real>
bool contains(const Ball<Real>& b, const Real960& x) {
  const Real960 distance = x - Real960(b.mid);
  return (distance < 0 ? -distance : distance) <= b.rad;
}

TEST(ExactSum, SumsOfProductsAreExact) {
  Rng rng(1);
  for (int i = 0; i < 2000; ++i) {
    ExactSum<40> sum;
    Real960 exact = 0;
    for (int k = 0; k < 12; ++k) {
      const double a = wild(rng), b = wild(rng);
      sum.add_product(a, b);
      exact += Real960(a) * Real960(b);
    }
    EXPECT_EQ(sum.sign(), exact > 0 ? 1 : -1);
    Real960 total = 0;
    for (std::size_t k = 0; k < sum.size(); ++k) total += sum.term(k);
    EXPECT_EQ(total, exact);
  }
}

/// Long sums leave alone what is far below a new term: it must not show.
TEST(ExactSum, TermsOfAllSizesInAnyOrder) {
  Rng rng(2);
  for (int i = 0; i < 4000; ++i) {
    ExactSum<24> sum;
    Real960 exact = 0;
    for (int k = 0; k < 20; ++k) {
      double x = std::ldexp(rng.sign() * (rng.chance(0.3) ? 1 : rng.real(1, 2)), rng.between(-150, 150));
      if (sum.size() > 0 && rng.chance(0.3)) {
        // About half a unit in the last place of a term, or of its neighbours in the other direction.
        x = std::ldexp(sum.term(static_cast<std::size_t>(rng.below(static_cast<int>(sum.size())))),
                       rng.between(52, 55));
      }
      sum.add(x);
      exact += Real960(x);
    }
    Real960 seen = 0;
    for (std::size_t k = 0; k < sum.size(); ++k) seen += Real960(sum.term(k));
    EXPECT_EQ(seen, exact);
    EXPECT_EQ(sum.sign(), exact > 0 ? 1 : (exact < 0 ? -1 : 0));
    ExactSum<32> turned;
    turned.assign(sum, -1);
    EXPECT_EQ(turned.sign(), -sum.sign());
    EXPECT_EQ(turned.size(), sum.size());
    for (std::size_t k = 0; k < sum.size(); ++k) EXPECT_EQ(turned.term(k), -sum.term(k));
  }
}

TEST(ExactSum, CancellationLeavesExactlyZero) {
  ExactSum<16> sum;
  sum.add_product(0.1, 0.3);
  sum.add(1e-300);
  sum.subtract_product(0.3, 0.1);
  EXPECT_EQ(sum.sign(), 1);
  sum.add(-1e-300);
  EXPECT_TRUE(sum.is_zero());
  EXPECT_EQ(sum.sign(), 0);
}

/// Law 1 of Ball, for every operation, at every stage.
template <class Real>
void ball_containment() {
  Rng rng(2);
  for (int i = 0; i < 3000; ++i) {
    const double a = wild(rng, 3), b = wild(rng, 3);
    const double ra = rng.chance(0.3) ? 0 : std::fabs(wild(rng, 2)) * 1e-4,
                 rb = rng.chance(0.3) ? 0 : 1e-3 * rng.unit();
    const Ball<Real> x(Real(a), ra), y(Real(b), rb);
    const Real960 p = Real960(a) + Real960(ra) * rng.real(-1, 1), q = Real960(b) + Real960(rb) * rng.real(-1, 1);
    EXPECT_TRUE(contains<Real>(x + y, p + q));
    EXPECT_TRUE(contains<Real>(x - y, p - q));
    EXPECT_TRUE(contains<Real>(x * y, p * q));
    EXPECT_TRUE(contains<Real>(x / y, p / q));
    if (p > 0) {
      EXPECT_TRUE(contains<Real>(sqrt(x), sqrt(p))) << a << " " << ra;
    }
    if ((x + y).sign() != 0) {
      EXPECT_EQ((x + y).sign(), p + q > 0 ? 1 : -1);
    }
  }
}
TEST(Ball, ContainmentInDoubles) { ball_containment<double>(); }
TEST(Ball, ContainmentAt320Bits) { ball_containment<Real320>(); }
TEST(Ball, ContainmentAt960Bits) { ball_containment<Real960>(); }

TEST(Ball, WhatIsUndefinedHasNoSign) {
  using B = Ball<double>;
  EXPECT_EQ((B::exact(1) / B(0.0, 0.5)).sign(), 0);
  EXPECT_EQ((B::exact(1) / B(0.0, 0.0)).sign(), 0);
  const B huge = B::exact(1e308) * B::exact(1e308);
  EXPECT_EQ((huge - huge).sign(), 0);
  EXPECT_EQ((B(0.0, std::numeric_limits<double>::infinity()) * B::exact(0)).sign(), 0);
  EXPECT_EQ(sqrt(B(-1.0, 0.5)).sign(), 0);
}

TEST(Ball, RadiiAreTight) {
  const Ball<double> third = Ball<double>::exact(1) / Ball<double>::exact(3);
  EXPECT_LT(third.rad, 1e-16);
  const Ball<Real320> precise = Ball<Real320>::exact(1) / Ball<Real320>::exact(3);
  EXPECT_LT(precise.rad, 1e-95);
  EXPECT_GT(precise.rad, 0);
}

/// Each stage's sine and cosine against the next one's.
template <class Real, class Better>
void sin_cos_against(double limit) {
  Rng rng(3);
  for (int i = 0; i < 3000; ++i) {
    const double x = i % 3 == 0 ? rng.real(-limit, limit) : (i % 3 == 1 ? rng.real(-4, 4) : wild(rng, 4));
    const SinCos<Real> got = sin_cos(Ball<Real>::exact(x));
    const SinCos<Better> want = sin_cos(Ball<Better>::exact(x));
    EXPECT_TRUE(contains<Real>(got.sin, Real960(want.sin.mid))) << x;
    EXPECT_TRUE(contains<Real>(got.cos, Real960(want.cos.mid))) << x;
    EXPECT_LT(got.sin.rad, (std::is_same_v<Real, double> ? 2e-15 : 1e-80)) << x;
  }
}
TEST(SinCos, DoublesAgainst320Bits) { sin_cos_against<double, Real320>(5e5); }
TEST(SinCos, LargeAnglesGoThroughMultiPrecision) { sin_cos_against<double, Real960>(1e15); }
TEST(SinCos, Stage320Against960) { sin_cos_against<Real320, Real960>(1e6); }

TEST(SinCos, NearMultiplesOfAQuarterTurn) {
  for (int k = -2000; k < 2000; ++k) {
    double x = k * 1.5707963267948966;
    for (int step = 0; step < 5; ++step, x = std::nextafter(x, INFINITY)) {
      const SinCos<double> got = sin_cos(Ball<double>::exact(x));
      const SinCos<Real320> want = sin_cos(Ball<Real320>::exact(x));
      ASSERT_TRUE(contains<double>(got.sin, Real960(want.sin.mid))) << x;
      ASSERT_TRUE(contains<double>(got.cos, Real960(want.cos.mid))) << x;
    }
  }
}

TEST(SinCos, KnownValues) {
  const SinCos<Real960> one = sin_cos(Ball<Real960>::exact(1));
  const mpz_class digits(
      "84147098480789650665250232163029899962256306079837106567275170999191040439123966894863974354");
  const Fraction scale(mpz_class("1" + std::string(92, '0')));
  EXPECT_LT(abs(Fraction(exact_fraction(one.sin.mid) - digits / scale)),
            Fraction(1) / mpz_class("1" + std::string(88, '0')));
  const Ball<Real960> unit = one.sin * one.sin + one.cos * one.cos - Ball<Real960>::exact(1);
  EXPECT_EQ(unit.sign(), 0);
  EXPECT_LT(unit.magnitude(), 1e-180);
}

/// A jet over an interval encloses value, slope and curvature at every point of it (by finer jets at points).
TEST(Jet, EnclosesOverIntervals) {
  Rng rng(4);
  const auto f = [](const Jet<double>& t) {
    Jet<double> sine, cosine;
    sin_cos(t * Ball<double>::exact(1.7), sine, cosine);
    return sqrt(Jet<double>::constant(2.5) + sine) / (Jet<double>::constant(3.0) + t * cosine);
  };
  for (int i = 0; i < 500; ++i) {
    const double m = rng.real(-1, 1), r = rng.real(0, 0.2), p = m + r * rng.real(-1, 1);
    const auto at = [](const Ball<double>& t) {
      return Jet<double>{t, Ball<double>::exact(1), Ball<double>::exact(0)};
    };
    const Jet<double> wide = f(at(Ball<double>(m, r))), point = f(at(Ball<double>::exact(p)));
    EXPECT_TRUE(contains(wide.v, Real960(point.v.mid)));
    EXPECT_TRUE(contains(wide.d, Real960(point.d.mid)));
    EXPECT_TRUE(contains(wide.dd, Real960(point.dd.mid)));
    // The derivatives are those of the values.
    const double h = 1e-4;
    const double before = f(at(Ball<double>::exact(p - h))).v.mid, after = f(at(Ball<double>::exact(p + h))).v.mid;
    EXPECT_NEAR(point.d.mid, (after - before) / (2 * h), 1e-6);
    EXPECT_NEAR(point.dd.mid, (after - 2 * point.v.mid + before) / (h * h), 1e-5);
  }
}

TEST(Polynomial, RangeIsTightAtARootOfOrderSix) {
  using B = Ball<Real320>;
  BallPolynomial<Real320> c;
  for (const double x : {64.0, -192.0, 240.0, -160.0, 60.0, -12.0, 1.0}) c.push_back(B::exact(x));  // (t - 2)^6
  const Jet<Real320> over = polynomial_range(c, B(Real320(2), 0x1p-20));
  EXPECT_LT(over.v.magnitude(), 0x1p-115);
  const Jet<Real320> plain =
      Jet<Real320>::polynomial(std::vector<double>{64, -192, 240, -160, 60, -12, 1}, B(Real320(2), 0x1p-20));
  EXPECT_GT(plain.v.magnitude(), 0x1p-20);  // Horner's rule would hide it
}

/// It holds both ends, and is hardly longer than the interval, however short that is.
TEST(Ball, AboutAShortMiddleIsHardlyLonger) {
  using B = Ball<Real320>;
  Rng rng(21);
  for (int i = 0; i < 4000; ++i) {
    const Real320 at = Real320(rng.real(-2, 2)) / Real320(3);
    const Real320 length = ldexp(Real320(rng.real(0.1, 1)) / Real320(7), -rng.below(300));
    const B ball = B::about_short_middle(at, at + length);
    const Fraction lo = exact_fraction(at), hi = exact_fraction(Real320(at + length));
    const Fraction middle = exact_fraction(ball.mid), reach = exact_fraction(ball.rad);
    EXPECT_LE(middle - reach, lo);
    EXPECT_GE(middle + reach, hi);
    EXPECT_LE(lo, middle);
    EXPECT_LE(middle, hi);
    EXPECT_LE(reach, (hi - lo) * Fraction(51, 100) + fraction_of_two(-310));
  }
}

/// Ranges in doubles hold all values, and tell a sign nearly wherever sharp ones do: coefficients of any size,
/// intervals of any length, and points.
TEST(Polynomial, RangesInDoublesHoldTheValuesAndTellTheSigns) {
  using B = Ball<Real320>;
  Rng rng(22);
  int decided = 0, decided_in_doubles = 0;
  for (int i = 0; i < 4000; ++i) {
    BallPolynomial<Real320> c;
    std::vector<Fraction> exact;
    for (int k = rng.between(1, 8); k >= 0; --k) {
      const Real320 x = ldexp(Real320(rng.real(-1, 1)) / Real320(3), -rng.below(rng.chance(0.5) ? 3 : 250));
      c.push_back(B(x, 0));
      exact.push_back(exact_fraction(x));
    }
    const Real320 middle = ldexp(Real320(rng.real(-1, 1)) / Real320(3), -rng.below(60));
    const double reach = rng.chance(0.3) ? 0 : std::ldexp(1.0, -rng.below(90));
    const B t(middle, reach);
    if (is_decisive(polynomial_range(c, t), t)) ++decided;
    const std::optional<Jet<Real320>> range = decisive_range_in_doubles(c, t);
    if (!range) continue;
    ++decided_in_doubles;
    EXPECT_TRUE(is_decisive(*range, t));
    for (const int share : {-1, 0, 1}) {
      const Fraction at = exact_fraction(middle) + share * exact_fraction(reach);
      Fraction v = 0, d = 0;
      for (std::size_t k = exact.size(); k-- > 0;) {
        d = d * at + v;
        v = v * at + exact[k];
      }
      EXPECT_LE(abs(Fraction(v - exact_fraction(range->v.mid))), exact_fraction(range->v.rad));
      EXPECT_LE(abs(Fraction(d - exact_fraction(range->d.mid))), exact_fraction(range->d.rad));
    }
  }
  EXPECT_GT(decided, 2000);
  EXPECT_GT(decided_in_doubles, decided * 9 / 10);
  EXPECT_LE(decided_in_doubles, decided);
}

TEST(RootIsolation, FindsTheFirstChangeOfSignOnly) {
  using B = Ball<Real320>;
  // (t - 1)^2 (t - 2)(t - 3): touches zero at 1 without changing sign. A certified method cannot see that it only
  // touches, so the double root is lifted by 2^-200 as the displacement would.
  const auto f = [](const B& t) {
    const Jet<Real320> x{t, B::exact(1), B::exact(0)};
    const auto minus = [&](double r) { return x - Jet<Real320>::constant(r); };
    return (minus(1) * minus(1) + Jet<Real320>::constant(0x1p-200)) * minus(2) * minus(3);
  };
  auto root = first_sign_change<Real320>(f, 1, Real320(0), Real320(10));
  ASSERT_TRUE(root);
  refine(f, 1, *root);
  EXPECT_LT(abs(Real320(root->lo - 2)), Real320(1e-80));
  EXPECT_LE(root->lo, 2);
  EXPECT_GE(root->hi, 2);
  EXPECT_FALSE(first_sign_change<Real320>(f, 1, Real320(0), Real320(1.9)));
  EXPECT_FALSE(first_sign_change<Real320>(f, -1, Real320(2.5), Real320(2.9)));
}

TEST(RootIsolation, SplitsADoubleRootThatIsLowered) {
  using B = Ball<Real320>;
  const auto f = [](const B& t) {
    const Jet<Real320> x{t, B::exact(1), B::exact(0)};
    const auto y = x - Jet<Real320>::constant(1.0);
    return y * y - Jet<Real320>::constant(0x1.6p-200);
  };
  auto root = first_sign_change<Real320>(f, 1, Real320(0), Real320(2));
  ASSERT_TRUE(root);
  refine(f, 1, *root);
  const Real320 expected = Real320(1) - ldexp(sqrt(Real320(1.375)), -100);
  EXPECT_LE(root->lo, expected);
  EXPECT_GE(root->hi, expected);
  EXPECT_LT(Real320(root->hi - root->lo), ldexp(Real320(1), -150));
}

TEST(RootIsolation, SaysWhenItsPrecisionIsExhausted) {
  using B = Ball<Real320>;
  const auto f = [](const B& t) {
    const Jet<Real320> x{t, B::exact(1), B::exact(0)};
    const auto y = x - Jet<Real320>::constant(1.0);
    return y * y;  // an exact double root: no sign can be certified there
  };
  EXPECT_THROW(first_sign_change<Real320>(f, 1, Real320(0.3), Real320(2)), PrecisionExhausted);
}

}  // namespace
}  // namespace taut::testing
