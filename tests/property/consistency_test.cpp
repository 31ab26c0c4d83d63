// The answers of all questions about one scene say the same: brackets of one instant meet, without any tolerance, since
// each holds the instant itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "soak/soak_scene.hpp"
#include "support/consistency.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/outline.hpp"

namespace taut::testing {
namespace {

void expect_consistent(const Scene& scene) {
  for (const Touch touch : {Touch::open, Touch::closed}) {
    try {
      EXPECT_EQ(inconsistency(scene, touch, 10), "") << to_string(touch);
    } catch (const InputError&) {
      // Injected vertices may make boundaries cross.
    }
  }
}

TEST(Consistency, OfRandomScenes) {
  for (std::uint64_t number = 0; number < effort(1000); ++number) {
    SCOPED_TRACE("scene " + std::to_string(number));
    expect_consistent(soak_scene(number).scene);
    if (HasFailure()) return;
  }
}

TEST(Consistency, OfContactsAndGrazes) {
  for (std::uint64_t number = 0; number < effort(1000); ++number) {
    SCOPED_TRACE("contact scene " + std::to_string(number));
    expect_consistent(soak_contact_scene(number).scene);
    if (HasFailure()) return;
  }
}

TEST(Consistency, OfWorlds) {
  for (std::uint64_t seed = 0; seed < effort(100); ++seed) {
    SCOPED_TRACE("world " + std::to_string(seed));
    expect_consistent(scene_of(random_world(seed)));
    if (HasFailure()) return;
  }
}

Scene square_that_goes(const Coefficients& x, double end) {
  const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Scene scene;
  scene.end = end;
  scene.bodies = {{"a", square, {}}, {"b", square, {}}};
  scene.bodies[1].motion.pieces.push_back({});
  scene.bodies[1].motion.pieces[0].x = x;
  return scene;
}

/// Two bodies overlap at rest, and are not tested: a third one begins to move later. Parts of the time in which nothing
/// moves are about the same pairs.
TEST(Consistency, WhereNothingMovesForAWhile) {
  Scene scene = square_that_goes({}, 10);
  Body& mover = scene.bodies.emplace_back(scene.bodies[1]);
  mover.name = "c";
  for (Point& p : mover.polygon) p.x += 4;
  mover.motion.pieces = {{}, {}};
  mover.motion.pieces[0].until = 5;
  mover.motion.pieces[1].x = {0, 0.5};
  mover.motion.pieces[1].origin = 5;
  scene.bodies[1].motion = {};
  for (const double t : {2.0, 5.0, 7.0}) {
    const Range found = range(scene, t);
    EXPECT_EQ(found.outcome, Outcome::free) << t;
    EXPECT_FALSE(found.from || found.to) << t;
    EXPECT_EQ(found.coverage.at_rest, 1U);
  }
  expect_consistent(scene);
  // Polygons around these discs overlap at the start.
  const double turn = std::sqrt(0.5);
  for (Body& body : scene.bodies) {
    const bool moves = body.name == "c";
    const double x = moves ? 2.03 * turn : 0, y = x;
    const auto at = [&](double side) { return fmt::format("{} {}", x + side, y); };
    body.curves = parse_path("M" + at(1) + " A1 1 0 0 1 " + at(-1) + " A1 1 0 0 1 " + at(1) + " Z");
    body.polygon.clear();
  }
  const Answer answer = check(scene);
  EXPECT_EQ(answer.outcome, Outcome::free);
  EXPECT_EQ(answer.coverage.at_rest, 1U);
}

/// A bar and a star meet a post in every turn, a million times, at rates without a common divisor, so never twice
/// alike. Only those overlaps matter that are next to the instant.
TEST(Consistency, OfARangeBetweenMillionsOfOverlaps) {
  Scene scene;
  scene.end = 4e6;
  scene.bodies = {{"bar", {{-3, -0.2}, {3, -0.2}, {3, 0.2}, {-3, 0.2}}, {}},
                  {"post", {{2.5, -1}, {3.5, -1}, {3.5, 1}, {2.5, 1}}, {}},
                  {"star", {{-0.1, 3.2}, {0.1, 3.2}, {0, 6}}, {}}};
  for (const auto& [body, rate] : {std::pair{0U, 1.0}, {2U, 0.7320508075688772}}) {
    MotionPiece& piece = scene.bodies[body].motion.pieces.emplace_back();
    piece.rotation = AngleRotation{{0, rate}};
  }
  for (const double t : {1.5, 2000002.0, 3999997.0}) {
    Scene around = scene;
    around.start = std::max(0.0, t - 10);
    around.end = std::min(scene.end, t + 10);
    const Range whole = range(scene, t), part = range(around, t);
    ASSERT_EQ(whole.outcome, Outcome::free) << t;
    ASSERT_EQ(part.outcome, Outcome::free) << t;
    for (const auto& [a, b] : {std::pair{whole.from, part.from}, {whole.to, part.to}}) {
      ASSERT_TRUE(a && b) << t;
      EXPECT_TRUE(a->lo <= b->hi && b->lo <= a->hi) << t;
    }
    EXPECT_EQ(whole.after->pair, part.after->pair);
    EXPECT_EQ(whole.before->pair, part.before->pair);
  }
}

/// (t - 1)^n more, or less, than what touches: the instant is in every bracket, and the wide ones say why.
TEST(Consistency, OfTouchesOfHighOrder) {
  for (int n = 2; n <= 16; n += 2) {
    for (const double sign : {1.0, -1.0}) {
      SCOPED_TRACE(std::to_string(n) + (sign > 0 ? ": touches" : ": parts and touches again"));
      Coefficients x{sign};
      for (int k = 1; k <= n; ++k) x.push_back(-x.back() * (n - k + 1) / k);
      x[0] += 2;
      const Scene scene = square_that_goes(x, 2);
      expect_consistent(scene);
      for (const Touch touch : {Touch::open, Touch::closed}) {
        CheckOptions options;
        options.touch = touch;
        for (const OverlapInterval& o : intervals(scene, options).intervals) {
          for (const auto& [time, contact] : {std::pair{o.from, o.enter}, std::pair{o.to, o.exit}}) {
            if (!contact) continue;
            EXPECT_LE(time.lo, 1);
            EXPECT_GE(time.hi, 1);
            EXPECT_EQ(contact->grazing, n >= 4);
          }
        }
      }
      if (sign > 0) continue;
      // Overlapping all the time but for an instant, at which they only touch.
      const Range range = taut::range(scene, 1);
      ASSERT_TRUE(range.from && range.to);
      EXPECT_TRUE(range.from->lo <= 1 && range.from->hi >= 1 - 1e-6);
      EXPECT_TRUE(range.to->lo <= 1 + 1e-6 && range.to->hi >= 1);
      CheckOptions closed;
      closed.touch = Touch::closed;
      EXPECT_THROW(taut::range(scene, 1, closed), InputError);
    }
  }
}

/// Who starts in touch and goes on into the other body overlaps from the start on.
TEST(Consistency, OfAContactAtTheStart) {
  for (const Coefficients& x : {Coefficients{2, -1}, Coefficients{2, 0, -1}, Coefficients{2, 1, -1}}) {
    const Scene scene = square_that_goes(x, 1.5);
    expect_consistent(scene);
    const Intervals found = intervals(scene);
    ASSERT_EQ(found.intervals.size(), 1u);
    EXPECT_EQ(found.intervals[0].from.lo, x[1] > 0 ? found.intervals[0].from.lo : 0);
  }
}

}  // namespace
}  // namespace taut::testing
