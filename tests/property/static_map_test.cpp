// A map answers as check() does about the same scene.
#include "taut/static_map.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
namespace {

/// A town: blocks in a grid, some of them courtyards with something inside, some of two parts.
std::vector<Body> random_town(Rng& rng, int side) {
  std::vector<Body> town;
  for (int i = 0; i < side * side; ++i) {
    if (rng.chance(0.2)) continue;
    const Point at{4.0 * (i % side), 4.0 * (i / side)};
    Body block;
    block.name = "block" + std::to_string(i);
    block.parts = {star_part(rng, at, 1.7, rng.chance(0.3) ? 0.7 : 0)};
    if (rng.chance(0.2)) block.parts.push_back(star_part(rng, {at.x + 1, at.y}, 0.8, 0));
    town.push_back(block);
  }
  return town;
}

Scene scene_with(std::vector<Body> town, Body mover, const Motion& motion, double end) {
  Scene scene;
  scene.end = end;
  scene.bodies = std::move(town);
  mover.motion = motion;
  scene.bodies.push_back(std::move(mover));
  return scene;
}

struct MapCounts {
  int free = 0, contact = 0, overlap = 0;
};

void expect_same(const Answer& map, const Answer& scene, MapCounts& counts) {
  ASSERT_STREQ(to_string(map.outcome), to_string(scene.outcome));
  EXPECT_EQ(map.free_until, scene.free_until);
  EXPECT_EQ(map.pair, scene.pair);
  ASSERT_EQ(map.contact.has_value(), scene.contact.has_value());
  if (map.contact) {
    EXPECT_EQ(map.contact->vertex, scene.contact->vertex);
    EXPECT_EQ(map.contact->edge, scene.contact->edge);
    EXPECT_EQ(map.contact->time.lo, scene.contact->time.lo);
    EXPECT_EQ(map.contact->time.hi, scene.contact->time.hi);
  }
  ++(map.outcome == Outcome::free ? counts.free : map.contact ? counts.contact : counts.overlap);
}

TEST(StaticMaps, AnswerAsScenesDo) {
  MapCounts counts;
  for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const std::vector<Body> town = random_town(rng, rng.between(1, 6));
    if (town.empty()) continue;
    const StaticMap map(town);
    Body robot;
    robot.name = "robot";
    robot.parts = {star_part(rng, {0, 0}, rng.real(0.05, 0.8), 0)};
    const StaticMap::Mover mover = map.prepare(robot);
    for (int i = 0; i < 8; ++i) {
      SCOPED_TRACE("question " + std::to_string(i));
      const Point at{rng.real(-2, 22), rng.real(-2, 22)};
      std::vector<Keyframe> way = random_keyframes(rng, 4, 6, {});
      for (Keyframe& k : way) {
        k.x += at.x;
        k.y += at.y;
        k.centre = {k.centre.x + at.x, k.centre.y + at.y};
      }
      const Motion motion = from_keyframes(way);
      CheckOptions options;
      options.touch = i % 4 == 3 ? Touch::closed : Touch::open;
      const Answer answer = map.check(mover, motion, 0, 4, options);
      ASSERT_NO_FATAL_FAILURE(expect_same(answer, check(scene_with(town, robot, motion, 4), options), counts));
      EXPECT_EQ(answer.coverage.pairs, town.size());
      EXPECT_EQ(answer.coverage.apart + answer.coverage.tested, town.size());
      // What is overlapped at the start is overlapped there.
      const auto overlapped = map.overlapped(mover, motion, 0, options.touch);
      if (options.touch == Touch::open) {
        EXPECT_EQ(overlapped.has_value(), answer.outcome == Outcome::overlap_at_start);
      }
      if (overlapped) {
        EXPECT_EQ(overlapped, (*answer.pair)[0]);
      }
    }
  }
  EXPECT_GE(counts.free, static_cast<int>(enough(60)));
  EXPECT_GE(counts.contact, static_cast<int>(enough(60)));
  EXPECT_GE(counts.overlap, static_cast<int>(enough(20)));
}

TEST(StaticMaps, ManyThreadsOneMap) {
  Rng rng(77);
  const std::vector<Body> town = random_town(rng, 5);
  const StaticMap map(town);
  Body robot;
  robot.name = "robot";
  robot.polygon = {{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}};
  const StaticMap::Mover mover = map.prepare(robot);
  std::vector<Motion> motions;
  for (int i = 0; i < 100; ++i) {
    const Keyframe from{0, rng.real(-2, 18), rng.real(-2, 18), 0}, to{1, rng.real(-2, 18), rng.real(-2, 18), 90};
    motions.push_back(from_keyframes({from, to}));
  }
  const auto ask_all = [&](const StaticMap& of, const StaticMap::Mover& who, std::vector<std::string>& said) {
    for (const Motion& motion : motions) {
      const Answer answer = of.check(who, motion, 0, 1);
      said.push_back(std::string(to_string(answer.outcome)) + " " + std::to_string(answer.free_until));
    }
  };
  // Both begin with nothing prepared.
  std::vector<std::string> alone, first, second;
  const StaticMap own(town);
  ask_all(own, own.prepare(robot), alone);
  std::thread other([&] { ask_all(map, mover, first); });
  ask_all(map, mover, second);
  other.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

std::string fault_in(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(StaticMaps, RefuseWhatIsNoMap) {
  // An empty map would have nothing to test.
  EXPECT_NE(fault_in([] { StaticMap map({}); }).find("no bodies"), std::string::npos);
  Body wall;
  wall.name = "wall";
  wall.polygon = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  Body cart = wall;
  cart.name = "cart";
  cart.motion.pieces = {{{0, 1}, {}, NoRotation{}}};
  EXPECT_NE(fault_in([&] { StaticMap map({wall, cart}); }).find("cart: the body moves"), std::string::npos);
  EXPECT_NE(fault_in([&] { StaticMap map({wall, wall}); }).find("two bodies are called \"wall\""), std::string::npos);
  const StaticMap map({wall});
  Body large = wall;
  large.name = "ship";
  large.polygon[1].x = 40;
  EXPECT_NE(fault_in([&] { map.prepare(large); }).find("ship: the shape has coordinates beyond"), std::string::npos);
  const StaticMap far({wall}, 100);
  const StaticMap::Mover ship = far.prepare(large);
  EXPECT_NE(fault_in([&] { map.check(ship, {}, 0, 1); }).find("another map"), std::string::npos);
  EXPECT_NE(fault_in([&] { far.check(ship, {}, 1, 0); }).find("ends before it starts"), std::string::npos);
  Motion jump;
  jump.pieces = {{{0}, {}, NoRotation{}, 0.5}, {{50}, {}, NoRotation{}}};
  EXPECT_NE(fault_in([&] { far.check(ship, jump, 0, 1); }).find("ship: motion piece 0: the motion jumps"),
            std::string::npos);
  EXPECT_EQ(far.overlapped(ship, {}, 0), BodyId{0});
}

/// A map of nothing is free; and limits are limits.
TEST(StaticMaps, EdgesOfTheQuestion) {
  Body wall;
  wall.name = "wall";
  wall.polygon = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  const StaticMap map({wall});
  Body dot = wall;
  dot.name = "dot";
  dot.polygon = {{0, 0}, {0.1, 0}, {0, 0.1}};
  const StaticMap::Mover mover = map.prepare(dot);
  Motion down;
  down.pieces = {{{2}, {3, -1}, NoRotation{}}};
  const Answer hit = map.check(mover, down, 0, 10);
  ASSERT_TRUE(hit.contact);
  EXPECT_EQ(hit.contact->time.lo, 2);
  EXPECT_EQ((*hit.pair)[0], 0);
  EXPECT_EQ((*hit.pair)[1], 1);
  std::atomic<bool> stop{true};
  CheckOptions options;
  options.limits.stop = &stop;
  Motion spin;
  spin.pieces = {{{2}, {1.15}, AngleRotation{{0, 100000}}}};
  const Answer stopped = map.check(mover, spin, 0, 10, options);
  EXPECT_EQ(stopped.outcome, Outcome::undecided);
  EXPECT_EQ(stopped.reason, "interrupted");
  // Resting on the wall: free, and touching; touching counts with closed touching.
  Motion on;
  on.pieces = {{{1, 1}, {1}, NoRotation{}}};
  const Answer slides = map.check(mover, on, 0, 1);
  EXPECT_EQ(slides.outcome, Outcome::free);
  EXPECT_TRUE(slides.touching);
  options = {};
  options.touch = Touch::closed;
  EXPECT_EQ(map.check(mover, on, 0, 1, options).outcome, Outcome::contact);
  EXPECT_EQ(map.overlapped(mover, on, 0), std::nullopt);
  EXPECT_EQ(map.overlapped(mover, on, 0, Touch::closed), BodyId{0});
}

}  // namespace
}  // namespace taut::testing
