// Sums of a few doubles, in exact rational numbers. Their parts do not overlap, but the largest may be far from the
// sum: what is left where numbers have cancelled is as small as what was lost before.
#include "numeric/short_sum.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certificate/precise_time.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// Each term is independent of the others, or cancels about what there is so far.
ShortSum random_sum(Rng& rng) {
  ExactSum<ShortSum::capacity> sum;
  const int terms = rng.between(0, ShortSum::capacity);
  for (int k = 0; k < terms; ++k) {
    const double so_far = sum.approximate();
    const double x = std::ldexp(rng.real(-1, 1), -rng.between(0, 120));
    sum.add(rng.chance(0.4) ? -so_far * (1 + std::ldexp(rng.between(-3, 3), -rng.between(20, 52))) : x);
  }
  return ShortSum::of(sum);
}

mpq_class rational_of(const ShortSum& x) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += mpq_class(x.part(i));
  return sum;
}

TEST(ShortSum, IsComparedExactly) {
  Rng rng(41);
  int close = 0;
  for (std::uint64_t round = 0; round < effort(100000); ++round) {
    const ShortSum a = random_sum(rng);
    // Another one, or about the same as one double.
    const double near = a.approximate() * (1 + std::ldexp(rng.between(-9, 9), -rng.between(1, 53)));
    const ShortSum b = rng.chance(0.5) ? ShortSum(near) : random_sum(rng);
    const mpq_class difference = rational_of(a) - rational_of(b);
    ASSERT_EQ(a.compare(b), sgn(difference)) << "round " << round;
    ASSERT_EQ(b.compare(a), -sgn(difference)) << "round " << round;
    close += abs(difference) * 1000 < abs(rational_of(a));
  }
  EXPECT_GT(close, static_cast<int>(effort(10000)));
}

TEST(ShortSum, LiesBetweenTheDoublesNextToIt) {
  Rng rng(42);
  for (std::uint64_t round = 0; round < effort(100000); ++round) {
    const ShortSum a = random_sum(rng);
    const mpq_class number = rational_of(a);
    const double lo = a.floor(), hi = a.ceiling();
    ASSERT_LE(mpq_class(lo), number);
    ASSERT_GT(mpq_class(std::nextafter(lo, INFINITY)), number);
    ASSERT_GE(mpq_class(hi), number);
    ASSERT_LT(mpq_class(std::nextafter(hi, -INFINITY)), number);
    EXPECT_LE(abs(number - mpq_class(a.approximate())), abs(number) * mpq_class(0x1p-51));
  }
}

TEST(ShortSum, ComparesAndRoundsExactly) {
  const auto number = [](std::initializer_list<double> parts) {
    ExactSum<8> sum;
    for (const double x : parts) sum.add(x);
    return ShortSum::of(sum);
  };
  const ShortSum one = number({1}), more = number({1, 0x1p-200}), less = number({1, -0x1p-200});
  EXPECT_EQ(one.compare(one), 0);
  EXPECT_LT(one.compare(more), 0);
  EXPECT_GT(one.compare(less), 0);
  EXPECT_EQ(more.floor(), 1);
  EXPECT_EQ(more.ceiling(), std::nextafter(1, 2));
  EXPECT_EQ(less.floor(), std::nextafter(1, 0));
  EXPECT_EQ(less.ceiling(), 1);
  EXPECT_EQ(one.floor(), 1);
  EXPECT_EQ(one.ceiling(), 1);
  EXPECT_EQ(ShortSum(0).compare(number({0x1p-300})), -1);
  EXPECT_EQ(ShortSum(0).floor(), 0);
  // The same number, split differently.
  EXPECT_EQ(number({1, 0x1p-53, 0x1p-54}).compare(number({1, 0x1.8p-53})), 0);
  EXPECT_EQ(more.real() - one.real(), RealMax(0x1p-200));
}

/// The largest part of this sum is 2^-93, and the sum 1.25 times that.
TEST(ShortSum, OfWhatIsLeftTheLargestPartIsNotAll) {
  ExactSum<3> sum;
  sum.add(0x1p-41);
  sum.add(0x1p-95);
  sum.add(-0x1p-41 + 0x1p-93);
  const ShortSum left = ShortSum::of(sum);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_GT(left.compare(ShortSum(1.125 * 0x1p-93)), 0);
  EXPECT_EQ(left.floor(), 1.25 * 0x1p-93);
  EXPECT_FALSE(PreciseTime(left, left, Stage::doubles).certainly_before(PreciseTime::between(1.125 * 0x1p-93, 1)));
}

}  // namespace
}  // namespace taut::testing
