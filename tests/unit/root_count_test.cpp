// How many roots there are, told by signs of derivatives, and searches that go by that.
#include "numeric/root_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "numeric/root_isolation.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using Number = Real320;
using NumberBall = Ball<Number>;
using Polynomial = BallPolynomial<Number>;

NumberBall exactly_at(double x) { return NumberBall(Number(x), 0.0); }

/// The product of x - r.
Polynomial with_roots(const std::vector<double>& roots) {
  Polynomial product;
  product.push_back(exactly_at(1));
  for (const double r : roots) {
    Polynomial next;
    for (std::size_t k = 0; k <= product.size; ++k) {
      NumberBall c = k > 0 ? product[k - 1] : exactly_at(0);
      if (k < product.size) c = c - product[k] * exactly_at(r);
      next.push_back(c);
    }
    product = next;
  }
  return product;
}

/// Roots are multiples of 1/8, so that no arithmetic rounds, and ends of intervals lie between them.
struct Case {
  std::vector<double> roots;
  double lo, hi;

  explicit Case(std::mt19937& random) {
    std::uniform_int_distribution<int> count(1, 7), place(-24, 24), width(1, 40);
    for (int k = count(random); k > 0; --k) roots.push_back(place(random) / 8.0);
    if (count(random) > 3) roots.push_back(roots.front());
    lo = place(random) / 8.0 + 0x1p-4;
    hi = lo + width(random) / 8.0;
  }
  int inside() const {
    return static_cast<int>(std::count_if(roots.begin(), roots.end(), [&](double r) { return lo < r && r <= hi; }));
  }
  int sign_at_start() const {
    int sign = 1;
    for (const double r : roots) sign *= r > lo ? -1 : 1;
    return sign;
  }
};

/// Where all roots are real, the theorem of Budan and Fourier tells their number, not only a bound of it.
TEST(RootCount, IsThatOfPolynomialsWhoseRootsAreReal) {
  std::mt19937 random(20261125);
  int decided = 0;
  for (int round = 0; round < 3000; ++round) {
    const Case c(random);
    const double middle = c.lo + (c.hi - c.lo) / 2;
    const Polynomial about = expanded(with_roots(c.roots), exactly_at(middle));
    const RootCount<Number> count(about, exactly_at(c.lo - middle), exactly_at(c.hi - middle));
    const int most = count.most(c.sign_at_start());
    ASSERT_GE(most, c.inside()) << "round " << round;
    if (most == RootCount<Number>::many) continue;
    // A derivative may be zero at an end.
    decided += most == c.inside();
  }
  EXPECT_GT(decided, 2000);
}

/// Signs that are not known at an end count for more roots, never for fewer.
TEST(RootCount, IsNoSmallerWhereEndsAreVague) {
  std::mt19937 random(7);
  for (int round = 0; round < 1000; ++round) {
    const Case c(random);
    const double middle = c.lo + (c.hi - c.lo) / 2;
    const Polynomial about = expanded(with_roots(c.roots), exactly_at(middle));
    const NumberBall lo(Number(c.lo - middle), 0x1p-5), hi(Number(c.hi - middle), 0x1p-5);
    ASSERT_GE(RootCount<Number>(about, lo, hi).most(c.sign_at_start()), c.inside()) << "round " << round;
  }
}

/// (t - c)^order + lift, by its Taylor polynomial as forms have it; counts how often it is asked.
class HighTouch {
 public:
  HighTouch(double place, int order, double lift) : place_(place) {
    for (int k = 0; k < order; ++k) c_.push_back(exactly_at(k == 0 ? lift : 0));
    c_.push_back(exactly_at(1));
    c_.push_back(exactly_at(0.5));
  }
  Jet<Number> decisive_range(const NumberBall& t) const {
    ++asked;
    return polynomial_range(c_, t - exactly_at(place_));
  }
  NumberBall telling_value(const NumberBall& t) const { return polynomial_value(c_, t - exactly_at(place_)); }
  bool is_expanded(const NumberBall&) const { return true; }
  std::optional<Polynomial> expansion(const NumberBall& t) const {
    return expanded(c_, NumberBall(t.mid, 0.0) - exactly_at(place_));
  }
  mutable int asked = 0;

 private:
  double place_;
  Polynomial c_;
};

TEST(SearchByDerivatives, PassesATouchOfHighOrderInFewSteps) {
  for (int order = 2; order <= 8; order += 2) {
    for (const double place : {0.3, 0.5, 1.0, 1.7}) {
      const HighTouch f(place, order, 0x1p-200);
      EXPECT_FALSE(first_sign_change<Number>(f, 1, Number(0.0), Number(2.0)));
      // Halving alone takes one step for each bit of the distance within which the lift decides, and more.
      EXPECT_LT(f.asked, 40) << "order " << order << " at " << place;
    }
  }
}

TEST(SearchByDerivatives, FindsTheFirstOfTwoRootsThatNearlyMeet) {
  for (int order = 2; order <= 8; order += 2) {
    const HighTouch f(0.3, order, -0x1p-160);
    auto root = first_sign_change<Number>(f, 1, Number(0.0), Number(2.0));
    ASSERT_TRUE(root) << order;
    refine(f, 1, *root);
    EXPECT_LT(f.asked, 60) << order;
    // Where (t - 0.3)^order is about 2^-160.
    const double before = -RealTraits<Number>::to_double(Number(root->hi - Number(0.3)));
    EXPECT_NEAR(std::log2(before) * order, -160, 0.5) << order;
  }
}

TEST(SearchByDerivatives, FindsTheRootThatATouchOfOddOrderCrossesAt) {
  for (int order = 3; order <= 7; order += 2) {
    const HighTouch f(0.7, order, 0x1p-160);
    auto root = first_sign_change<Number>(f, -1, Number(0.0), Number(2.0));
    ASSERT_TRUE(root) << order;
    refine(f, -1, *root);
    EXPECT_LT(f.asked, 60) << order;
    const double before = -RealTraits<Number>::to_double(Number(root->hi - Number(0.7)));
    EXPECT_NEAR(std::log2(before) * order, -160, 0.5) << order;
  }
}

}  // namespace
}  // namespace taut::testing
