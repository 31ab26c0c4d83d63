// The one function of the C library that answers rest on.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "numeric/two_words.hpp"

namespace taut {
using namespace internal;
namespace {

/// Is it the double next to the root? By whole numbers: x = m 4^k with m in [2^104, 2^106), so that the root of m is
/// between two whole numbers R - 1/2 and R + 1/2.
bool is_rounded_root(double root, double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const int shift = 52 + ((exponent + 1) & 1);
  const auto m = static_cast<TwoWords>(std::ldexp(fraction, 53)) << shift;
  const auto r = static_cast<std::uint64_t>(std::ldexp(root, (53 + shift - exponent) / 2));
  const TwoWords below = 2 * r - 1, above = 2 * r + 1;
  return below * below < 4 * m && 4 * m < above * above;
}

TEST(Sqrt, IsRoundedOnce) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200000; ++i) {
    const double x = std::ldexp(static_cast<double>(random() >> 11 | 1), static_cast<int>(random() % 200) - 100);
    ASSERT_TRUE(is_rounded_root(std::sqrt(x), x)) << x;
  }
}

}  // namespace
}  // namespace taut
