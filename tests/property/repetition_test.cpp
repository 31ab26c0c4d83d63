// Bodies that turn uniformly are after a while only where they have been before: what holds for one period holds for
// any number of them, and costs as much.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <sstream>

#include "motion/far_pieces.hpp"
#include "numeric/budget.hpp"
#include "support/effort.hpp"
#include "support/random_polygons.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr long double two_pi = 6.283185307179586476925286766559L;

MotionPiece turning(double rate, double from = 0, Point pivot = {}) {
  MotionPiece piece;
  piece.rotation = AngleRotation{{from, rate}};
  piece.pivot = pivot;
  return piece;
}

/// With so few digits that small multiples of it are doubles.
double short_rate(Rng& rng) { return (1 << 16 | rng.below(1 << 18)) * 0x1p-17; }

TEST(Repetition, BeginsOnePeriodAfterTheLastJoint) {
  Rng rng(1);
  for (int k = 0; k < 1000; ++k) {
    const double unit = short_rate(rng) * std::ldexp(1, rng.below(40) - 20), joint = rng.real(-5, 5);
    const int times_p = 1 + rng.below(6), times_q = rng.below(7);
    MotionPiece before;
    before.x = {0, 1};
    before.until = joint;
    const MotionChain p{PieceList({before, turning(-times_p * unit, 1)})}, q{PieceList({turning(times_q * unit)})};
    const double found = repeats_from(p, q, -10, 1e300);
    const long double exact = joint + two_pi / (std::gcd(times_p, times_q) * static_cast<long double>(unit));
    EXPECT_GE(found, exact);
    EXPECT_LE(found - exact, 0x1p-48L * (std::fabs(joint) + exact - joint));
    EXPECT_EQ(repeats_from(p, q, -10, found), INFINITY);
  }
}

TEST(Repetition, IsNotThereForOtherMotions) {
  const auto from = [](const MotionPiece& p, const MotionPiece& q) {
    return repeats_from({PieceList({p})}, {PieceList({q})}, 0, 1e6);
  };
  EXPECT_LT(from(turning(1), {}), 7);
  MotionPiece sliding = turning(1), bent = turning(1), faster = turning(1), circling;
  sliding.x = {0, 1e-9};
  faster.rotation = AngleRotation{{0, 1, 1e-9}};
  bent.rotation = DirectionRotation{{1, 1}, {0, 1}};
  EXPECT_EQ(from(sliding, {}), INFINITY);
  EXPECT_EQ(from(faster, {}), INFINITY);
  EXPECT_EQ(from(bent, turning(1)), INFINITY);
  EXPECT_EQ(from({}, {}), INFINITY);
  // The two meet again in this way after 2^52 turns only.
  EXPECT_EQ(from(turning(1), turning(std::nextafter(1, 2))), INFINITY);
  circling.orbit = {{1, 1}, {0, 2}};
  circling.origin = 3;
  EXPECT_NEAR(from(circling, turning(3)), 6.2832, 1e-4);
}

/// Both about points near their middles, at multiples of one rate; some move on a carrier that turns, too.
Scene rotating(Rng& rng, double periods) {
  const PolygonPair pair = random_pair(rng, rng.chance(0.5) ? Family::stars : Family::convex);
  const auto middle_of = [](const Polygon& polygon) {
    Point sum;
    for (const Point& v : polygon) sum = {sum.x + v.x, sum.y + v.y};
    return Point{sum.x / static_cast<double>(polygon.size()), sum.y / static_cast<double>(polygon.size())};
  };
  const double unit = short_rate(rng), share = rng.real(0, 1);
  const int p = 1 + rng.below(3), q = rng.below(3), carried = rng.below(3);
  Scene scene;
  scene.start = rng.chance(0.5) ? 0 : rng.real(-9, 9);
  scene.end = scene.start + (periods + share) * static_cast<double>(two_pi) / unit;
  scene.bodies = {{"p", pair.p, {{turning(p * unit, 0, middle_of(pair.p))}}},
                  {"q", pair.q, {{turning(-q * unit, 0, middle_of(pair.q))}}}};
  if (carried == 0) return scene;
  // Far from everything, and ignored.
  scene.bodies.push_back({"carrier", {{1e3, 0}, {1e3 + 1, 0}, {1e3, 1}}, {{turning(carried * unit / 2)}}});
  scene.bodies[0].relative_to = "carrier";
  scene.ignore = {{"carrier", "*"}};
  return scene;
}

template <class Ask>
std::uint64_t work_to(const Ask& ask) {
  const std::uint64_t before = work_spent();
  ask();
  return work_spent() - before;
}

TEST(Repetition, ChangesNothingButTheTime) {
  int contacts = 0, free = 0;
  for (std::uint64_t seed = 1; seed <= effort(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng once(seed), often(seed);
    // Two, since with a carrier at half the rate a period takes twice as long.
    const Scene few = rotating(once, 2), many = rotating(often, 1e5);
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
      CheckOptions options;
      options.engine = engine;
      Answer a, b;
      const std::uint64_t of_few = work_to([&] { a = check(few, options); });
      const std::uint64_t of_many = work_to([&] { b = check(many, options); });
      ASSERT_EQ(a.outcome, b.outcome);
      EXPECT_LE(of_many, 4 * of_few + 2000);
      if (a.contact) {
        EXPECT_LE(std::max(a.contact->time.lo, b.contact->time.lo), std::min(a.contact->time.hi, b.contact->time.hi));
        ++contacts;
      }
      if (a.outcome != Outcome::free) continue;
      ++free;
      EXPECT_EQ(b.free_until, many.end);
      EXPECT_TRUE(intervals(many).intervals.empty());
    }
  }
  EXPECT_GE(contacts, enough(60));
  EXPECT_GE(free, enough(60));
}

TEST(Repetition, KeepsTheLeastDistance) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= effort(100); ++seed) {
    SCOPED_TRACE(seed);
    Rng once(seed), often(seed);
    const Scene few = rotating(once, 2), many = rotating(often, 1e5);
    if (check(few).outcome != Outcome::free) continue;
    const Clearance a = clearance(few), b = clearance(many);
    ASSERT_TRUE(a.nearest && b.nearest);
    EXPECT_LE(std::max(a.nearest->lo, b.nearest->lo), std::min(a.nearest->hi, b.nearest->hi));
    EXPECT_EQ(check_clearance(many, a.nearest->lo * (1 - 1e-9)).outcome, Outcome::free);
    EXPECT_EQ(check_clearance(many, a.nearest->hi * (1 + 1e-9)).outcome,
              check_clearance(few, a.nearest->hi * (1 + 1e-9)).outcome);
    ++compared;
  }
  EXPECT_GE(compared, enough(10));
}

TEST(Repetition, IsKnownToVerifiers) {
  int proved = 0;
  for (std::uint64_t seed = 1; seed <= effort(100); ++seed) {
    SCOPED_TRACE(seed);
    Rng once(seed), often(seed);
    const Scene few = rotating(once, 2), many = rotating(often, 1e5);
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
      if (engine == EngineChoice::kinetic && few.bodies.size() > 2) continue;
      CheckOptions options;
      options.engine = engine;
      std::stringstream of_few, of_many;
      const Answer a = prove(few, of_few, options), b = prove(many, of_many, options);
      ASSERT_EQ(a.outcome, b.outcome);
      if (a.outcome == Outcome::overlap_at_start) continue;
      EXPECT_LE(of_many.str().size(), 4 * of_few.str().size() + 200);
      const Verified verified = verify(many, of_many);
      EXPECT_EQ(verified.outcome, b.outcome);
      if (b.outcome == Outcome::free) {
        EXPECT_EQ(verified.free_until, many.end);
      }
      ++proved;
    }
  }
  EXPECT_GE(proved, enough(40));
}

}  // namespace
}  // namespace taut::testing
