// Lines in time, in doubles: their bounds hold for the same functions in 960 bits.
#include "certificate/exact_line.hpp"

#include <gtest/gtest.h>

#include "line_setting.hpp"
#include "motion/taylor_model_cache.hpp"

namespace taut::testing {
using namespace internal;
namespace {

struct Lines {
  int roots = 0, holding = 0, signs = 0, unknown = 0;
};

void compare(const FastLine& line, const PreciseFunction<Real960>& f, const MotionSegment& segment, Rng& rng,
             Lines& seen) {
  const auto exact = [&f](double t) { return f.value(Ball<Real960>::exact(t)); };
  const double t = rng.below(4) ? rng.real(segment.start, segment.end) : segment.start;
  const double until = rng.below(4) ? rng.real(t, segment.end) : t;
  const Bounded v = line.at(t);
  EXPECT_LE(std::fabs(RealTraits<Real960>::to_double(Real960(exact(t).mid - Real960(v.value)))),
            v.error * (1 + 0x1p-30));
  const int sign = line.sign_over(t, until);
  if (sign == 0) {
    ++seen.unknown;
    return;
  }
  ++seen.signs;
  EXPECT_EQ(exact(t).sign(), sign);
  EXPECT_EQ(exact(until).sign(), sign);
  if (line.holds(sign, until, segment.end)) {
    ++seen.holding;
    EXPECT_EQ(exact(segment.end).sign(), sign);
  }
  double lo, hi;
  if (!line.root(sign, lo, hi)) return;
  ++seen.roots;
  EXPECT_GE(exact(lo).sign() * sign, 0);
  EXPECT_LE(exact(hi).sign() * sign, 0);
  // Where doubles do not cancel, the root is known nearly to the last bits.
  EXPECT_LE(hi - lo,
            0x1p-40 * (std::fabs(lo) + 1) + 4 * line.at(lo).error / (std::fabs(line.slope.value) - line.slope.error));
}

TEST(FastLine, BoundsHoldForTheExactFunction) {
  Rng rng(21);
  Lines seen;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    LineSetting s = LineSetting::of(seed, seed % 3 != 0);
    // Segments far from the origin of time, and short ones.
    if (seed % 5 == 1) s.segment.end = s.segment.start + 1e-9;
    if (seed % 5 == 2) s.segment = MotionSegment::motion(s.segment.p, s.segment.q, 1000, 1001);
    TaylorModelCache clock;
    clock.reset(s.segment);
    ASSERT_TRUE(clock.straight());
    for (int k = 0; k < 20; ++k) {
      const CertificateFunction triple = s.triple(rng);
      const Measure measure = any_measure(rng);
      const FastFunction f = FastFunction::undisplaced(s.segment, s.geometry, triple.measured(measure));
      const FastLine line(f, clock.straight_side(), clock.straight_middle());
      compare(line, PreciseFunction<Real960>(s.segment, s.geometry, triple.measured(measure)), s.segment, rng, seen);
    }
  }
  EXPECT_GT(seen.roots, 5000);
  EXPECT_GT(seen.holding, 5000);
  EXPECT_GT(seen.signs, 15000);
  EXPECT_GT(seen.unknown, 100);
}

TEST(FastLine, IsOfferedForStraightTranslationsOnly) {
  TaylorModelCache clock;
  const MotionPiece rest, straight{{0, 1}, {2}, NoRotation{}}, curved{{0, 1, 1}, {2}, NoRotation{}},
      turning{{0}, {0}, AngleRotation{{0, 1}}};
  const MotionSegment segments[] = {
      MotionSegment::motion(rest, straight, 0, 1), MotionSegment::motion(straight, straight, 0, 1),
      MotionSegment::motion(rest, curved, 0, 1), MotionSegment::motion(rest, turning, 0, 1),
      MotionSegment::bridging(rest, straight, rest, straight, 1)};
  const bool expected[] = {true, true, false, false, false};
  for (int i = 0; i < 5; ++i) {
    clock.reset(segments[i]);
    EXPECT_EQ(clock.straight(), expected[i]) << "leg " << i;
  }
}

}  // namespace
}  // namespace taut::testing
