// Sums of two doubles, in exact rational numbers: the bound holds, and is zero only where nothing was rounded.
#include "numeric/exact_sum.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

mpq_class middle_of(const DoubleDouble& x) { return mpq_class(x.leading()) + mpq_class(x.rest()); }

/// A number and what encloses it.
struct KnownSum {
  DoubleDouble sum;
  mpq_class number;

  bool holds() const {
    if (!(sum.error() < INFINITY)) return true;
    return abs(number - middle_of(sum)) <= mpq_class(sum.error()) && abs(number) <= mpq_class(sum.most()) &&
           std::fabs(sum.rest()) <= 0x1p-52 * std::fabs(sum.leading()) + 0x1p-1020;
  }
};

/// With few digits, as coordinates on a grid have; with all of them; or so small that products underflow.
KnownSum random_number(Rng& rng) {
  if (rng.chance(0.05)) return {};
  double x = rng.chance(0.5) ? rng.between(1, 999) : 1 + rng.unit();
  const int kind = rng.below(10);
  x = rng.sign() * std::ldexp(x, kind == 0 ? -rng.between(300, 1020) : -rng.between(0, 40));
  return {DoubleDouble::exact(x), mpq_class(x)};
}

TEST(DoubleDouble, ResultsAreWithinTheirBounds) {
  Rng rng(31);
  int exact = 0, rounded = 0;
  for (std::uint64_t round = 0; round < effort(20000); ++round) {
    KnownSum x = random_number(rng);
    for (int step = 0; step < 6; ++step) {
      const KnownSum y = rng.chance(0.3) ? x : random_number(rng);
      switch (rng.below(3)) {
        case 0:
          x = {x.sum + y.sum, x.number + y.number};
          break;
        case 1:
          x = {x.sum - y.sum, x.number - y.number};
          break;
        default:
          x = {x.sum * y.sum, x.number * y.number};
      }
      ASSERT_TRUE(x.holds()) << "round " << round << ", step " << step;
      ++(x.sum.error() == 0 ? exact : rounded);
    }
  }
  EXPECT_GT(exact, static_cast<int>(effort(20000)));
  EXPECT_GT(rounded, static_cast<int>(effort(20000)));
}

/// What forms are made of: a 2 x 2 determinant of differences, of a few digits or of all.
TEST(DoubleDouble, DeterminantsOfGridPointsAreExact) {
  Rng rng(32);
  for (std::uint64_t round = 0; round < effort(20000); ++round) {
    const auto coordinate = [&] { return DoubleDouble::exact(rng.between(-1000, 1000) / 1024.0); };
    const DoubleDouble ax = coordinate(), ay = coordinate(), dx = coordinate(), dy = coordinate();
    const DoubleDouble k = coordinate();
    const DoubleDouble parallel = (dx * k) * (dy) - (dy * k) * dx;
    EXPECT_EQ(parallel.leading(), 0);
    EXPECT_EQ(parallel.error(), 0);
    EXPECT_EQ(((ax - dx) * (ay - dy)).error(), 0);
  }
}

TEST(DoubleDouble, SumsHaveTwiceTheDigits) {
  Rng rng(33);
  for (std::uint64_t round = 0; round < effort(20000); ++round) {
    const DoubleDouble x = DoubleDouble::exact(rng.real(1, 2)) * DoubleDouble::exact(rng.real(1, 2));
    const DoubleDouble y = DoubleDouble::exact(rng.real(1, 2)) * DoubleDouble::exact(rng.real(1, 2));
    EXPECT_EQ(x.error(), 0);
    EXPECT_LE((x * y).error(), 0x1p-98);
    EXPECT_LE((x + y).error(), 0x1p-102);
  }
}

}  // namespace
}  // namespace taut::testing
