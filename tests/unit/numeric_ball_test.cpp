// The laws of balls in exact rational numbers, which share nothing with them: what is in the operands gives what is in
// the result, bounds round outwards, and signs are true. Every operation, every precision, numbers of any size.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "numeric/ball.hpp"
#include "support/effort.hpp"
#include "support/fraction.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// Any magnitude: about 1, often; where doubles are denormal, sometimes.
int any_exponent(Rng& rng) {
  const int choice = rng.below(8);
  return choice < 4 ? rng.between(-4, 4) : choice < 6 ? rng.between(-220, 60) : rng.between(-1040, 300);
}

double any_double(Rng& rng) {
  if (rng.chance(0.05)) return 0;
  // Few bits: ties and cancellation. Many ones: roundings that carry.
  double x = rng.chance(0.3) ? rng.between(1, 9) : 1 + rng.unit();
  if (rng.chance(0.2)) x = 2 - std::ldexp(x, -50);
  return rng.sign() * std::ldexp(x, any_exponent(rng));
}

template <class Real>
Real any_real(Rng& rng) {
  Real x(any_double(rng));
  if constexpr (!std::is_same_v<Real, double>) {
    // As many bits as there are, and often long runs of zeros among them.
    for (int gap = 53; gap < RealTraits<Real>::bits && rng.chance(0.9); gap += rng.between(20, 120)) {
      x += ldexp(x, -gap) * Real(rng.real(-1, 1));
    }
  }
  return x;
}

template <class Real>
Ball<Real> any_ball(Rng& rng) {
  const Real mid = any_real<Real>(rng);
  if (rng.chance(0.3)) return Ball<Real>(mid, 0.0);
  // From far below a unit in the last place to far above the number.
  const double size = std::fabs(static_cast<double>(mid));
  const int below = rng.chance(0.2) ? -2 : rng.between(0, RealTraits<Real>::bits + 10);
  return Ball<Real>(mid, rng.chance(0.1) ? std::fabs(any_double(rng)) : std::ldexp(size * (0.5 + rng.unit()), -below));
}

struct Interval {
  Fraction lo, hi;
  template <class Real>
  static Interval of(const Ball<Real>& b) {
    const Fraction mid = exact_fraction(b.mid), rad(b.rad);
    return {mid - rad, mid + rad};
  }
  bool has(const Fraction& x) const { return lo <= x && x <= hi; }
};

template <class Real>
bool is_finite(const Ball<Real>& b) {
  if constexpr (std::is_same_v<Real, double>) {
    return std::isfinite(b.rad) && std::isfinite(b.mid);
  } else {
    return std::isfinite(b.rad) && b.mid.is_defined();
  }
}

/// Both ends, the middle, and some between.
std::vector<Fraction> members(Rng& rng, const Interval& b) {
  const Fraction share(rng.below(1001), 1000);
  return {b.lo, b.hi, (b.lo + b.hi) / 2, b.lo + (b.hi - b.lo) * share};
}

template <class Real>
class BallLaws {
 public:
  explicit BallLaws(std::uint64_t seed) : rng_(seed) {}

  void one_round() {
    const Ball<Real> a = any_ball<Real>(rng_), b = any_ball<Real>(rng_);
    const Interval x = Interval::of(a), y = Interval::of(b);
    bounds(a, x);
    one(-a, x, [](const Fraction& p) -> Fraction { return -p; });
    two(a + b, x, y, [](const Fraction& p, const Fraction& q) -> Fraction { return p + q; });
    two(a - b, x, y, [](const Fraction& p, const Fraction& q) -> Fraction { return p - q; });
    two(a * b, x, y, [](const Fraction& p, const Fraction& q) -> Fraction { return p * q; });
    const double factor = any_double(rng_);
    one(a * factor, x, [&](const Fraction& p) -> Fraction { return p * Fraction(factor); });
    if (y.has(0)) {
      EXPECT_EQ((a / b).sign(), 0);
    } else {
      two(a / b, x, y, [](const Fraction& p, const Fraction& q) -> Fraction { return p / q; });
    }
    roots(a, x);
    const Ball<Real> both = hull(a, b);
    if (is_finite(both)) {
      for (const Fraction& end : {x.lo, x.hi, y.lo, y.hi}) EXPECT_TRUE(Interval::of(both).has(end));
    }
    const Ball<Real> between = Ball<Real>::between(std::min(a.mid, b.mid), std::max(a.mid, b.mid));
    EXPECT_TRUE(Interval::of(between).has(exact_fraction(a.mid)) && Interval::of(between).has(exact_fraction(b.mid)));
  }

 private:
  void bounds(const Ball<Real>& a, const Interval& x) {
    EXPECT_LE(exact_fraction(a.lower()), x.lo);
    EXPECT_GE(exact_fraction(a.upper()), x.hi);
    if (a.rad == 0) {
      EXPECT_EQ(a.lower(), a.mid);
      EXPECT_EQ(a.upper(), a.mid);
    }
    EXPECT_GE(Fraction(a.magnitude()), abs(x.lo));
    EXPECT_GE(Fraction(a.magnitude()), abs(x.hi));
    const int sign = a.sign();
    EXPECT_TRUE(sign == 0 || (sign > 0 ? x.lo > 0 : x.hi < 0));
    const Fraction mid = exact_fraction(a.mid);
    EXPECT_LT(Fraction(double_below(a.mid)), mid);
    EXPECT_GT(Fraction(double_above(a.mid)), mid);
    const double floor = double_floor(a.mid);
    EXPECT_LE(Fraction(floor), mid);
    EXPECT_GT(Fraction(std::nextafter(floor, INFINITY)), mid);
  }
  template <class Operation>
  void one(const Ball<Real>& got, const Interval& x, const Operation& operation) {
    if (!is_finite(got)) return;
    const Interval result = Interval::of(got);
    for (const Fraction& p : members(rng_, x)) EXPECT_TRUE(result.has(operation(p)));
  }
  template <class Operation>
  void two(const Ball<Real>& got, const Interval& x, const Interval& y, const Operation& operation) {
    if (!is_finite(got)) return;
    const Interval result = Interval::of(got);
    for (const Fraction& p : members(rng_, x)) {
      for (const Fraction& q : members(rng_, y)) EXPECT_TRUE(result.has(operation(p, q)));
    }
  }
  /// Of members that are not negative, by squares.
  void roots(const Ball<Real>& a, const Interval& x) {
    const Ball<Real> got = sqrt(a);
    if (!is_finite(got)) return;
    const Interval result = Interval::of(got);
    for (const Fraction& p : members(rng_, x)) {
      if (p < 0) continue;
      EXPECT_TRUE(result.hi >= 0 && result.hi * result.hi >= p);
      EXPECT_TRUE(result.lo <= 0 || result.lo * result.lo <= p);
    }
  }

  Rng rng_;
};

template <class Real>
void check_laws(std::uint64_t rounds) {
  for (std::uint64_t seed = 0; seed < effort(rounds); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    BallLaws<Real>(seed).one_round();
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(BallLaws, HoldInDoubles) { check_laws<double>(20000); }
TEST(BallLaws, HoldAt320Bits) { check_laws<Real320>(6000); }
TEST(BallLaws, HoldAt960Bits) { check_laws<Real960>(4000); }

}  // namespace
}  // namespace taut::testing
