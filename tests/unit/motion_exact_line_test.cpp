// Lines in time, exactly: against the same functions in 960 bits.
#include "certificate/exact_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certificate/precise_triple.hpp"
#include "line_setting.hpp"

namespace taut::testing {
using namespace internal;
namespace {

TEST(ExactLine, SignsAreThoseOf960Bits) {
  Rng rng(1);
  int zeros_in_doubles = 0;
  for (std::uint64_t seed = 0; seed < 1200; ++seed) {
    const LineSetting s = LineSetting::of(seed, seed % 3 != 0);
    ASSERT_TRUE(ExactLine::fits(s.segment));
    for (int k = 0; k < 20; ++k) {
      const CertificateFunction triple = s.triple(rng);
      const Measure measure = any_measure(rng);
      const ExactLine line(s.segment, s.geometry, triple.measured(measure));
      ASSERT_TRUE(line.exact());
      const PreciseFunction<Real960> f(s.segment, s.geometry, triple.measured(measure));
      const double t = rng.below(2) ? rng.real(0, 1) : static_cast<double>(rng.below(5)) / 4;
      const Ball<Real960> value = f.value(Ball<Real960>::exact(t));
      if (std::fabs(RealTraits<Real960>::to_double(value.mid)) < 1e-40) ++zeros_in_doubles;
      EXPECT_EQ(line.sign_over(PreciseTime::between(t, t)), value.sign()) << "seed " << seed;
    }
  }
  EXPECT_GT(zeros_in_doubles, 50);  // only the displacement tells
}

TEST(ExactLine, RootsAreWhereTheFunctionChangesItsSign) {
  Rng rng(2);
  int roots = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const LineSetting s = LineSetting::of(seed, seed % 3 != 0);
    for (int k = 0; k < 20; ++k) {
      const CertificateFunction triple = s.triple(rng);
      const Measure measure = any_measure(rng);
      const ExactLine line(s.segment, s.geometry, triple.measured(measure));
      if (line.slope_sign() == 0) continue;
      const auto root = line.root(Stage::precise);
      ASSERT_TRUE(root);
      ++roots;
      const PreciseFunction<Real960> f(s.segment, s.geometry, triple.measured(measure));
      const Real960 lo = root->lo(), hi = root->hi();
      const int before = f.value(Ball<Real960>(lo, 0.0)).sign(), after = f.value(Ball<Real960>(hi, 0.0)).sign();
      if (lo == hi) {
        EXPECT_EQ(line.sign_over(*root), 0);
      } else {
        EXPECT_EQ(before, -line.slope_sign()) << "seed " << seed;
        EXPECT_EQ(after, line.slope_sign()) << "seed " << seed;
      }
      EXPECT_LE(RealTraits<Real960>::magnitude(Real960(hi - lo)), 0x1p-190 * (1 + std::fabs(root->floor())));
      EXPECT_LE(Real960(root->floor()), lo);
      EXPECT_GT(Real960(std::nextafter(root->floor(), INFINITY)), lo);
      EXPECT_GE(Real960(root->ceiling()), hi);
      // A coarser root is one of the same function.
      const auto coarse = line.root(Stage::precise, 1e-10);
      ASSERT_TRUE(coarse);
      EXPECT_FALSE(coarse->certainly_before(*root));
      EXPECT_FALSE(root->certainly_before(*coarse));
    }
  }
  EXPECT_GT(roots, 2000);
}

TEST(ExactLine, FailuresAreThoseThatHighPrecisionFinds) {
  Rng rng(3);
  int found = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const LineSetting s = LineSetting::of(seed, true);
    for (int k = 0; k < 10; ++k) {
      const CertificateFunction triple = s.triple(rng);
      const PreciseTriple precise(s.segment, s.geometry, triple);
      const PreciseTime start = PreciseTime::between(0, 0);
      const int sign = precise.sign_at(start, Stage::precise);
      if (sign == 0) continue;
      const auto failure = precise.first_failure(sign, start, 1);
      const PreciseFunction<Real960> f(s.segment, s.geometry, triple);
      auto root = first_sign_change<Real960>(f, sign, Real960(0), Real960(1));
      ASSERT_EQ(failure.has_value(), root.has_value()) << "seed " << seed;
      if (!failure) continue;
      ++found;
      taut::internal::refine(f, sign, *root);
      EXPECT_LE(failure->lo(), RealMax(root->hi));
      EXPECT_GE(failure->hi(), RealMax(root->lo));
    }
  }
  EXPECT_GT(found, 200);
}

TEST(ExactLine, SaysSoWhenProductsUnderflow) {
  LineSetting s = LineSetting::of(3, false);
  const auto tiny = [](const SharedPolygon& polygon) {
    std::vector<DisplacedPoint> out = polygon->points;
    for (DisplacedPoint& p : out) p = {p.x * 1e-150, p.y * 1e-150, p.dx * 1e-150, p.dy * 1e-150};
    return out;
  };
  s.geometry = PairGeometry(tiny(s.geometry.p()), tiny(s.geometry.q()));
  Rng rng(4);
  EXPECT_FALSE(ExactLine(s.segment, s.geometry, s.triple(rng)).exact());
}

}  // namespace
}  // namespace taut::testing
