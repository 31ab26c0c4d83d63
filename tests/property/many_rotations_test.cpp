// Bodies that rotate hundreds or millions of times. Where nothing comes near, many rotations cost as much as few; where
// something does, skipping the rest must not change the answer.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "numeric/budget.hpp"
#include "support/effort.hpp"
#include "support/random_polygons.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A stick that rotates once per unit of time, and drifts by `drift` in all.
Scene stick_beside(const Polygon& other, const Motion& motion, double rotations, double drift = 0) {
  Scene scene;
  scene.start = 0;
  scene.end = rotations;
  scene.bodies = {
      {"stick", {{-1, -0.05}, {1, -0.05}, {1, 0.05}, {-1, 0.05}}, from_velocity({drift / rotations, 0}, 360)},
      {"other", other, motion}};
  return scene;
}

const Polygon still_wall{{1.5, -1}, {2, -1}, {2, 1}, {1.5, 1}};
const Polygon spun_bar{{1.6, -0.05}, {3.6, -0.05}, {3.6, 0.05}, {1.6, 0.05}};

Answer by_boxes(const Scene& scene) {
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  return check(scene, options);
}

std::uint64_t work_to(const std::function<void()>& ask) {
  const std::uint64_t before = work_spent();
  ask();
  return work_spent() - before;
}

TEST(ManyRotations, CostAsMuchAsFewWhereNothingIsNear) {
  const Motion spin = from_velocity({0, 0}, -240, {2.6, 0});
  const auto few = [&](auto ask) { return work_to([&] { ask(stick_beside(still_wall, {}, 1e3)); }); };
  const auto many = [&](auto ask) { return work_to([&] { ask(stick_beside(still_wall, {}, 1e9)); }); };
  const auto checked = [](const Scene& scene) { EXPECT_EQ(by_boxes(scene).outcome, Outcome::free); };
  const auto in_turn = [](const Scene& scene) { EXPECT_EQ(check(scene).outcome, Outcome::free); };
  const auto without = [](const Scene& scene) { EXPECT_TRUE(intervals(scene).intervals.empty()); };
  const auto kept = [](const Scene& scene) { EXPECT_EQ(check_clearance(scene, 0.45).outcome, Outcome::free); };
  const auto nearest = [](const Scene& scene) {
    const Clearance found = clearance(scene);
    ASSERT_TRUE(found.nearest);
    EXPECT_NEAR(found.nearest->lo, 1.5 - std::hypot(1, 0.05), 1e-9);
    EXPECT_TRUE(found.wide.empty());
  };
  EXPECT_LE(many(checked), 2 * few(checked));
  EXPECT_LE(many(in_turn), 2 * few(in_turn));
  EXPECT_LE(many(without), 2 * few(without));
  EXPECT_LE(many(kept), 2 * few(kept));
  EXPECT_LE(many(nearest), 2 * few(nearest));
  // Two sticks that both rotate.
  EXPECT_LE(work_to([&] { checked(stick_beside(spun_bar, spin, 1e9)); }),
            2 * work_to([&] { checked(stick_beside(spun_bar, spin, 1e3)); }));
}

TEST(ManyRotations, FindTheContactHalfAMillionRotationsAway) {
  const Scene scene = stick_beside(still_wall, {}, 1e6, 1);
  Answer found;
  EXPECT_LE(work_to([&] { found = by_boxes(scene); }), 5000u);
  ASSERT_TRUE(found.contact);
  // A corner of the stick meets the wall when the stick's ring has come to it, within one rotation.
  EXPECT_NEAR(found.contact->time.lo, (1.5 - std::hypot(1, 0.05)) * 1e6, 1);
  EXPECT_EQ(check_clearance(scene, 0.2).first->time.lo < found.contact->time.lo, true);
}

Point middle_of(const Polygon& polygon) {
  Point sum;
  for (const Point& v : polygon) sum = {sum.x + v.x, sum.y + v.y};
  return {sum.x / static_cast<double>(polygon.size()), sum.y / static_cast<double>(polygon.size())};
}

/// Rotates up to 40 times each way about a point near the middle, or not, while it drifts by up to its size.
Motion drifting(Rng& rng, const Polygon& polygon) {
  const Point middle = middle_of(polygon);
  const double size = std::hypot(polygon[0].x - middle.x, polygon[0].y - middle.y);
  const double spin = rng.unit() < 0.3 ? 0 : rng.real(-40, 40) * 360;
  return from_velocity({rng.real(-size, size), rng.real(-size, size)}, spin, middle);
}

TEST(ManyRotations, HaveTheAnswersOfTheTiling) {
  int contacts = 0, free = 0;
  for (std::uint64_t seed = 1; seed <= effort(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    PolygonPair pair = random_pair(rng, rng.unit() < 0.5 ? Family::stars : Family::convex);
    // Farther from each other, so that one may rotate beside the other.
    const double away = rng.real(0, 4) * std::fabs(middle_of(pair.p).x - middle_of(pair.q).x);
    for (Point& v : pair.q) v.x += std::floor(away);
    Scene scene;
    scene.start = 0;
    scene.end = 1;
    scene.bodies = {{"a", pair.p, drifting(rng, pair.p)}, {"b", pair.q, drifting(rng, pair.q)}};
    CheckOptions options;
    options.engine = EngineChoice::both;
    options.limits.max_seconds = 5;
    const Answer answer = check(scene, options);  // throws where they differ
    if (answer.outcome == Outcome::contact) ++contacts;
    if (answer.outcome == Outcome::free) ++free;
  }
  EXPECT_GT(contacts, 3);
  EXPECT_GT(free, 3);
}

}  // namespace
}  // namespace taut::testing
