// A start near the last one: the same tiling as from scratch, and the same answers, byte for byte, whatever was asked
// before.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <utility>

#include "generators/generators.hpp"
#include "kinetic/session.hpp"
#include "pair/placement.hpp"
#include "support/effort.hpp"
#include "support/prepared_scene.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "taut/io.hpp"
#include "taut/warm_check.hpp"
#include "tiling/checks.hpp"
#include "tiling/static_tiling.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A body at this place and turn, from which it moves on as random motions do.
MotionPiece placed(const Point& at, double turn) {
  MotionPiece piece;
  piece.x = {at.x};
  piece.y = {at.y};
  if (turn != 0) piece.rotation = AngleRotation{{turn}};
  return piece;
}

/// Another question about the bodies of a scene: they have been moved and turned by little, and move on.
Scene moved_on(const Scene& scene, Rng& rng, double size) {
  Scene next = scene;
  next.start = rng.chance(0.5) ? 0 : rng.real(-3, 3);
  next.end = next.start + 1;
  for (Body& body : next.bodies) {
    const double turn = rng.chance(0.3) ? 0 : rng.real(-0.3, 0.3) * size;
    MotionPiece piece = placed({rng.real(-1, 1) * size, rng.real(-1, 1) * size}, turn);
    // At the start it is there.
    const double vx = rng.chance(0.4) ? 0 : rng.real(-2, 2), vy = rng.chance(0.4) ? 0 : rng.real(-2, 2);
    piece.x = {piece.x[0] - vx * next.start, vx};
    piece.y = {piece.y[0] - vy * next.start, vy};
    if (auto* angle = std::get_if<AngleRotation>(&piece.rotation); angle && rng.chance(0.6)) {
      const double rate = rng.real(-1, 1);
      angle->angle = {turn - rate * next.start, rate};
    }
    body.motion.pieces = {piece};
  }
  return next;
}

struct WarmCounts {
  std::map<std::string, int> roots;
  int warm = 0, asked = 0, events = 0;
  std::map<std::string, int> outcomes;
};

/// The map at the start, near the last one, against that from scratch.
void compare_map(const Scene& scene, Touch touch, NearStart& near, WarmCounts& counts) {
  Session session(scene, touch, nullptr, nullptr, &near);
  if (session.engine().state() == EngineState::overlap || !session.began_near()) return;
  const Engine& engine = session.engine();
  EXPECT_EQ(engine.events(), 0u);
  EXPECT_EQ(engine.time(), scene.start);
  const Placement placement(engine.geometry(), engine.segment(), scene.start);
  const StaticTiling fresh = build_tiling(placement);
  ASSERT_FALSE(fresh.overlap);
  ++counts.roots[to_string(fresh.root)];
  ASSERT_EQ(difference(engine.map(), fresh.map), "");
  ASSERT_EQ(find_fault(engine.map(), placement), "");
  const Session cold(scene, touch, nullptr);
  EXPECT_EQ(engine.active_certificates(), cold.engine().active_certificates());
  EXPECT_EQ(engine.initial_certificates(), cold.engine().initial_certificates());
}

std::string text(const Scene& scene, const Answer& answer, Touch touch) { return answer_json(scene, answer, touch); }

/// A scene, and how often it is asked about.
struct Question {
  Scene scene;
  int times;
};

/// Questions to one WarmCheck, in both modes: next(k) is the k-th of so many.
template <typename Next>
void ask_in_turn(int questions, const Next& next, WarmCounts& counts) {
  for (const Touch touch : {Touch::open, Touch::closed}) {
    CheckOptions options;
    options.touch = touch;
    options.engine = EngineChoice::kinetic;
    WarmCheck warm(options);
    NearStart near;
    for (int k = 0; k < questions && !::testing::Test::HasFailure(); ++k) {
      const auto [scene, times] = next(k);
      const Answer expected = check(scene, options);
      for (int again = 0; again < times; ++again) {
        const Answer answer = warm.check(scene);
        EXPECT_EQ(text(scene, answer, touch), text(scene, expected, touch)) << write_scene(scene);
        EXPECT_EQ(answer.events, expected.events);
        ++counts.outcomes[to_string(answer.outcome)];
      }
      compare_map(scene, touch, near, counts);
      ++counts.asked;
    }
    counts.warm += static_cast<int>(warm.warm_starts());
  }
}

void ask_many(const Scene& first, Rng& rng, int questions, double size, WarmCounts& counts) {
  const auto next = [&first, &rng, size](int k) {
    // Now and then the very same question.
    Scene scene = k == 0 ? first : moved_on(first, rng, size);
    return Question{std::move(scene), rng.chance(0.2) ? 2 : 1};
  };
  ask_in_turn(questions, next, counts);
}

void print(const WarmCounts& counts) {
  std::cout << counts.asked << " questions, " << counts.warm << " of them warm;";
  for (const auto& [root, n] : counts.roots) std::cout << ' ' << root << ' ' << n;
  for (const auto& [outcome, n] : counts.outcomes) std::cout << ' ' << outcome << ' ' << n;
  std::cout << '\n';
}

TEST(WarmCheck, AnswersAsIfNothingHadBeenAskedBefore) {
  Rng rng(91);
  WarmCounts counts;
  for (const Family family : {Family::apart, Family::intertwined, Family::nested, Family::corridor, Family::combs,
                              Family::spirals, Family::stars, Family::convex}) {
    for (std::uint64_t seed = 0; seed < std::max<std::uint64_t>(effort(40), 12) && !HasFailure(); ++seed) {
      const double size = std::ldexp(1.0, -rng.between(0, 8));
      ask_many(without_polygons(prepared(random_scene(seed, family))), rng, 8, size, counts);
    }
  }
  print(counts);
  EXPECT_GT(counts.warm, static_cast<int>(effort(500)));
  for (const char* root : {"disjoint", "bridged", "pinched"}) EXPECT_GT(counts.roots[root], 0) << root;
  // One in three hundred: there are some where all is asked.
  if (effort(40) == 40) {
    EXPECT_GT(counts.roots["mouth"], 0);
  }
  for (const char* outcome : {"free", "contact", "overlap_at_start"}) EXPECT_GT(counts.outcomes[outcome], 0) << outcome;
}

TEST(WarmCheck, OnCoarseGridsToo) {
  Rng rng(92);
  WarmCounts counts;
  SceneOptions options;
  options.grid = true;
  for (std::uint64_t seed = 0; seed < effort(60) && !HasFailure(); ++seed) {
    const Scene first = without_polygons(prepared(random_scene(seed, Family::combs, options)));
    ask_many(first, rng, 4, rng.chance(0.5) ? 0 : 0.25, counts);
  }
  print(counts);
  EXPECT_GT(counts.warm, static_cast<int>(effort(40)));
}

/// So many certificates that regions are looked for, on the way and after it.
TEST(WarmCheck, OfManyCertificates) {
  WarmCounts counts;
  gen::CombOptions combs;
  combs.teeth = 120;
  combs.swings = 4;
  combs.hit = true;
  gen::SpiralOptions spirals;
  gen::GearOptions gears;
  gears.teeth_1 = 24;
  gears.teeth_2 = 25;
  gears.hit = true;
  for (const Scene& given : {gen::make_combs(combs), gen::make_spiral(spirals), gen::make_gears(gears)}) {
    const Scene scene = without_polygons(prepared(given));
    // Along its own way, to and fro.
    const auto next = [&scene](int k) {
      Question question{scene, 1};
      question.scene.start += (scene.end - scene.start) * (k % 5) * 1e-4 * (k < 6 ? 1 : 30);
      return question;
    };
    ask_in_turn(12, next, counts);
  }
  print(counts);
  EXPECT_GT(counts.warm, 36);
  EXPECT_GT(counts.outcomes["contact"], 0);
}

TEST(WarmCheck, TakesScenesThatCannotBeginNear) {
  WarmCheck warm;
  Scene bare;
  bare.bodies = {{"a", {{0, 0}, {1, 0}, {0, 1}}, {}}, {"b", {{3, 0}, {4, 0}, {3, 1}}, {}}};
  EXPECT_EQ(warm.check(bare).outcome, Outcome::free);
  const Scene shaped = without_polygons(prepared(bare));
  EXPECT_EQ(warm.check(shaped).outcome, Outcome::free);
  EXPECT_EQ(warm.check(shaped).outcome, Outcome::free);
  EXPECT_EQ(warm.warm_starts(), 1u);
  // Other shapes, though they look the same; half a turn; refused input.
  EXPECT_EQ(warm.check(without_polygons(prepared(bare))).outcome, Outcome::free);
  EXPECT_EQ(warm.warm_starts(), 1u);
  Scene turned = shaped;
  turned.bodies[0].motion.pieces = {placed({0, 0}, 3)};
  warm.check(shaped);
  EXPECT_EQ(warm.check(turned).outcome, Outcome::free);
  EXPECT_EQ(warm.warm_starts(), 1u);
  Scene wrong = turned;
  wrong.end = -1;
  EXPECT_THROW(warm.check(wrong), InputError);
  EXPECT_EQ(warm.check(turned).outcome, Outcome::free);
  EXPECT_EQ(warm.warm_starts(), 2u);
}

}  // namespace
}  // namespace taut::testing
