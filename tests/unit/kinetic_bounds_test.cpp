// How long a certificate certainly lasts: bounds of the second and third order against dense sampling, and the clock's
// third derivatives and shared instants against multi-precision.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motion/taylor_model_cache.hpp"
#include "numeric/quadratic_bound.hpp"
#include "numeric/real.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

double of_any_size(Rng& rng, double decades) { return rng.sign() * std::pow(10.0, rng.real(-decades, decades)); }

/// a + b h + c h^2/2 - d h^3/6, exactly enough.
Real320 cubic(double a, double b, double c, double d, double h) {
  const Real320 x(h);
  return Real320(a) + x * (Real320(b) + x * (Real320(c) / 2 - x * Real320(d) / 6));
}

/// Positive at many instants of (0, h), those near its end included.
bool seen_positive(double a, double b, double c, double d, double h) {
  for (int k = 1; k <= 64; ++k) {
    for (const double t : {h * k / 65, h * (1 - std::pow(0.5, k))}) {
      if (t > 0 && t < h && !(cubic(a, b, c, d, t) > 0)) return false;
    }
  }
  return true;
}

TEST(QuadraticBound, HoldsAsLongAsItSays) {
  Rng rng(3);
  int cut_short = 0, throughout = 0;
  for (int i = 0; i < 4000; ++i) {
    const double a = std::fabs(of_any_size(rng, 3)), limit = std::fabs(of_any_size(rng, 1));
    double b = of_any_size(rng, 2), c = of_any_size(rng, 2);
    if (rng.chance(0.2)) c = b * b / (2 * a) * (1 + rng.sign() * std::pow(10.0, rng.real(-17, -1)));  // nearly touches
    const double h = positive_until(a, b, c, limit);
    EXPECT_TRUE(h >= 0 && h <= limit);
    EXPECT_TRUE(seen_positive(a, b, c, 0, h));
    if (positive_throughout(a, b, c, limit)) {
      ++throughout;
      EXPECT_TRUE(seen_positive(a, b, c, 0, limit));
    } else {
      ++cut_short;
    }
  }
  EXPECT_GT(throughout, 400);
  EXPECT_GT(cut_short, 400);
}

TEST(QuadraticBound, CubicHoldsAsLongAsItSaysAndNoShorter) {
  Rng rng(4);
  int longer = 0;
  for (int i = 0; i < 4000; ++i) {
    const double a = std::fabs(of_any_size(rng, 3)), limit = std::fabs(of_any_size(rng, 1));
    const double b = of_any_size(rng, 2), c = of_any_size(rng, 2),
                 d = rng.chance(0.1) ? 0 : std::fabs(of_any_size(rng, 2));
    const double h = positive_until(a, b, c, d, limit),
                 at_once = positive_until(a, b, c - d * limit * one_third, limit);
    EXPECT_TRUE(h >= 0 && h <= limit);
    EXPECT_GE(h, at_once * (1 - 0x1p-40));
    longer += h > 1.25 * at_once;
    EXPECT_TRUE(seen_positive(a, b, c, d, h));
  }
  EXPECT_GT(longer, 100);
}

TEST(QuadraticBound, SaysNothingOfWhatIsUnknown) {
  for (const double unknown : {std::nan(""), -std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(positive_throughout(1, unknown, 1, 1));
    EXPECT_FALSE(positive_throughout(1, 1, unknown, 1));
    EXPECT_EQ(positive_until(1, 1, unknown, 1, 1), 0);
  }
  EXPECT_FALSE(positive_throughout(-1, 0, 0, 1));
  EXPECT_EQ(positive_until(1, -1, 0, INFINITY, 1), 0);
}

/// The frame functions' side of one kind at t, from multi-precision: the functions and two derivatives.
const std::array<Jet<Real320>, 5>& side(const Frame<Real320>& f, bool pp) { return pp ? f.for_pp : f.for_qq; }

TEST(TaylorModelCache, SecondAndThirdDerivativesAndSharedInstants) {
  Rng rng(5);
  int compared = 0, shared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const MotionPiece p{
        {rng.real(-1, 1), rng.real(-1, 1)}, {rng.real(-1, 1)}, AngleRotation{{rng.real(-1, 1), rng.real(-3, 3)}}};
    const MotionPiece q{
        {rng.real(-1, 1), rng.real(-1, 1), rng.real(-1, 1)}, {0.5}, AngleRotation{{0, rng.real(-3, 3), 0.5}}};
    const MotionSegment segment = MotionSegment::motion(p, q, 0, 2);
    TaylorModelCache clock;
    clock.reset(segment);
    for (int k = 0; k < 30; ++k) {
      const double t = rng.real(0, 2);
      const bool pp = rng.chance(0.5);
      double at;
      const FrameSample near = clock.shortly_before(t, pp, at);
      ASSERT_LE(at, t);
      const ModelCell cell = clock.cell(t);
      ASSERT_GE(at, cell.start);
      ASSERT_LE(t - at, (cell.end - cell.start) / 16);
      shared += at < t;
      const FrameSample& now = clock.at(at, pp);
      const auto exact = frame(segment, Ball<Real320>::exact(at));
      const double later = std::min(cell.end, at + 1e-3), step = later - at;
      const auto ahead = frame(segment, Ball<Real320>::exact(later));
      for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(near.f[i], now.f[i]);
        EXPECT_EQ(near.d[i], now.d[i]);
      }
      if (!cell.sharp) continue;
      ++compared;
      for (std::size_t i = 0; i < 4; ++i) {
        const double second = RealTraits<Real320>::to_double(side(exact, pp)[i + 1].dd.mid);
        EXPECT_LE(std::fabs(near.dd[i] - second), i < 2 ? near.error_add : near.error_bdd);
        const double change = RealTraits<Real320>::to_double(side(ahead, pp)[i + 1].dd.mid) - second;
        EXPECT_LE(std::fabs(change), cell.third(pp).most[i] * step * (1 + 1e-9) + 1e-15);
      }
      // Larger cells say it of all their instants.
      for (const ModelCell* wide = clock.parent_bounds(cell); wide; wide = clock.parent_bounds(*wide)) {
        ASSERT_LE(wide->start, cell.start);
        ASSERT_GE(wide->end, cell.end);
        const FrameThird third = wide->third(pp);
        const double other = rng.real(wide->start, wide->end);
        const auto there = frame(segment, Ball<Real320>::exact(other));
        for (std::size_t i = 0; i < 4; ++i) {
          const Ball<Real320> change = side(there, pp)[i + 1].dd - side(exact, pp)[i + 1].dd;
          const double seen = std::fabs(RealTraits<Real320>::to_double(change.mid));
          EXPECT_LE(seen, third.most[i] * std::fabs(other - at) * (1 + 1e-9) + 1e-15);
          EXPECT_LT(third.most[i], 1e6);
        }
      }
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(shared, 1000);
}

}  // namespace
}  // namespace taut::testing
