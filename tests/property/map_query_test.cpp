// A planner's questions, held against check() about the same motions, and against poses on the way.
#include "taut/map_query.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <string>
#include <thread>

#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
namespace {

/// Obstacles with and without holes in a grid, and a room around all of them now and then.
std::vector<Body> obstacles(Rng& rng, int side) {
  std::vector<Body> all;
  for (int i = 0; i < side * side; ++i) {
    if (rng.chance(0.3)) continue;
    Body block;
    block.name = "block" + std::to_string(i);
    block.parts = {star_part(rng, {4.0 * (i % side), 4.0 * (i / side)}, 1.7, rng.chance(0.3) ? 0.7 : 0)};
    all.push_back(block);
  }
  if (rng.chance(0.5) || all.empty()) {
    const double lo = -5, hi = 4.0 * side + 1;
    Body room;
    room.name = "room";
    room.parts = {{{{lo - 1, lo - 1}, {hi + 1, lo - 1}, {hi + 1, hi + 1}, {lo - 1, hi + 1}},
                   {{{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}}}}};
    all.push_back(room);
  }
  return all;
}

Body star_robot(Rng& rng, const std::string& name, double size) {
  Body robot;
  robot.name = name;
  robot.parts = {star_part(rng, {rng.real(-0.2, 0.2), 0}, size, 0)};
  return robot;
}

/// On a quarter grid now and then, so that robots slide and touch.
PoseSE2 random_pose(Rng& rng, double lo, double hi) {
  if (rng.chance(0.2))
    return {std::floor(rng.real(lo, hi)) / 2, std::floor(rng.real(lo, hi)) / 2, radians(90.0 * rng.between(-2, 2))};
  return {rng.real(lo, hi), rng.real(lo, hi), rng.real(-3.2, 3.2)};
}

Motion line_of(const PoseSE2& a, const PoseSE2& b) {
  Motion motion;
  motion.pieces = {{{a.x, b.x - a.x}, {a.y, b.y - a.y}, AngleRotation{{a.angle, b.angle - a.angle}}}};
  return motion;
}

struct QueryCounts {
  int free = 0, contact = 0, overlap = 0;
  void add(Outcome o) { ++(o == Outcome::free ? free : o == Outcome::contact ? contact : overlap); }
};

/// With closed touching, check() says of what touches at the start that it is a contact there.
bool agree_on(Outcome query, const Answer& answer, double start) {
  if (query == answer.outcome) return true;
  return query == Outcome::overlap_at_start && answer.outcome == Outcome::contact && answer.contact->time.lo == start;
}

/// Enclosures of one instant have it in common; the first contact is the same.
void expect_agreement(const MapFinding& found, const Answer& answer, double start) {
  ASSERT_TRUE(agree_on(found.outcome, answer, start)) << to_string(found.outcome) << ", " << to_string(answer.outcome);
  if (found.outcome != Outcome::contact) return;
  EXPECT_LE(found.free_until, answer.contact->time.hi);
  EXPECT_GE(found.contact_by, answer.contact->time.lo);
  EXPECT_LE(found.free_until, found.contact_by);
  if (!answer.contact->grazing) {
    EXPECT_LT(found.contact_by - found.free_until, 1e-12);
  }
}

TEST(MapQueries, StraightWaysAsCheckSays) {
  QueryCounts counts;
  for (std::uint64_t seed = 0; seed < effort(80); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int side = rng.between(1, 5);
    const StaticMap map(obstacles(rng, side), 2);
    const StaticMap::Mover robot = map.prepare(star_robot(rng, "robot", rng.real(0.05, 0.9)));
    MapQueryOptions how;
    how.touch = seed % 4 == 3 ? Touch::closed : Touch::open;
    MapQuery query(map, robot, how);
    CheckOptions options;
    options.touch = how.touch;
    for (int i = 0; i < 30; ++i) {
      SCOPED_TRACE("question " + std::to_string(i));
      const PoseSE2 from = random_pose(rng, -3, 4.0 * side);
      PoseSE2 to = random_pose(rng, -3, 4.0 * side);
      if (rng.chance(0.5)) to = {from.x + rng.real(-1, 1), from.y + rng.real(-1, 1), from.angle + rng.real(-1, 1)};
      const Motion motion = line_of(from, to);
      const Answer answer = map.check(robot, motion, 0, 1, options);
      const MapFinding along = query.along(from, to);
      ASSERT_NO_FATAL_FAILURE(expect_agreement(along, answer, 0));
      counts.add(along.outcome);
      const MapFinding passes = query.passes(from, to);
      EXPECT_EQ(passes.free(), along.free());
      if (!along.free()) {
        EXPECT_LE(passes.free_until, along.contact_by);
        EXPECT_GE(passes.body, 0);
      }
      const double t = rng.unit();
      const MapFinding at = query.at(from), there = query.along(std::span(&motion, 1), t, t);
      EXPECT_EQ(at.free(), !map.overlapped(robot, motion, 0, how.touch).has_value());
      EXPECT_EQ(there.free(), !map.overlapped(robot, motion, t, how.touch).has_value());
    }
  }
  EXPECT_GE(counts.free, static_cast<int>(enough(300)));
  EXPECT_GE(counts.contact, static_cast<int>(enough(300)));
  EXPECT_GE(counts.overlap, static_cast<int>(enough(200)));
}

/// Turns about pivots and lines, one after the other, as cars drive; and now and then an arc in keyframes, which is no
/// even motion.
Motion drive(Rng& rng, const PoseSE2& from, double end) {
  Motion motion;
  double x = from.x, y = from.y, angle = from.angle;
  for (double t = 0; t < end; t += 1) {
    const double until = t + 1 < end ? t + 1 : INFINITY, side = rng.between(-1, 1), rho = rng.real(0.3, 2);
    const Point ahead{std::cos(angle), std::sin(angle)};
    if (side == 0) {
      motion.pieces.push_back({{x - rho * ahead.x * t, rho * ahead.x},
                               {y - rho * ahead.y * t, rho * ahead.y},
                               AngleRotation{{angle}},
                               until});
      x += rho * ahead.x;
      y += rho * ahead.y;
      continue;
    }
    const double spin = side * rng.real(0.2, 1.5);
    const Point centre{x - side * rho * ahead.y, y + side * rho * ahead.x};
    motion.pieces.push_back(
        {{centre.x}, {centre.y - side * rho}, AngleRotation{{angle - spin * t, spin}}, until, {0, side * rho}});
    angle += spin;
    x = centre.x + side * rho * std::sin(angle);
    y = centre.y - side * rho * std::cos(angle);
  }
  return motion;
}

TEST(MapQueries, DrivesAsCheckSays) {
  QueryCounts counts;
  int pieces = 0;
  for (std::uint64_t seed = 1000; seed < 1000 + effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int side = rng.between(1, 5);
    const StaticMap map(obstacles(rng, side), 2);
    const StaticMap::Mover robot = map.prepare(star_robot(rng, "robot", rng.real(0.05, 0.6)));
    MapQuery query(map, robot);
    for (int i = 0; i < 15; ++i) {
      SCOPED_TRACE("question " + std::to_string(i));
      const PoseSE2 from = random_pose(rng, -3, 4.0 * side);
      Motion motion = drive(rng, from, 3);
      if (i % 5 == 4) {
        std::vector<Keyframe> way = random_keyframes(rng, 3, 3, {});
        for (Keyframe& k : way) k = {k.t, k.x + from.x, k.y + from.y, k.angle_deg, k.way, k.centre, k.by_deg};
        motion = from_keyframes(way);
      }
      pieces += static_cast<int>(motion.pieces.size());
      const Answer answer = map.check(robot, motion, 0, 3);
      const MapFinding along = query.along(std::span(&motion, 1), 0, 3);
      ASSERT_NO_FATAL_FAILURE(expect_agreement(along, answer, 0));
      EXPECT_EQ(query.passes(std::span(&motion, 1), 0, 3).free(), along.free());
      counts.add(along.outcome);
    }
  }
  EXPECT_GE(pieces, static_cast<int>(enough(1800)));
  EXPECT_GE(counts.free, static_cast<int>(enough(80)));
  EXPECT_GE(counts.contact, static_cast<int>(enough(150)));
}

/// An arm of three links on a base that drives, as a scene with parents.
struct Arm {
  std::vector<Body> links;
  std::vector<int> parents{-1, 0, 1, 1};

  explicit Arm(Rng& rng) {
    for (int k = 0; k < 4; ++k) {
      Body link = star_robot(rng, "link" + std::to_string(k), rng.real(0.1, 0.5));
      if (k > 0) link.relative_to = "link" + std::to_string(parents[static_cast<std::size_t>(k)]);
      links.push_back(link);
    }
  }
  std::vector<RobotLink> in(const StaticMap& map) const {
    std::vector<RobotLink> all;
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body shape = links[k];
      shape.relative_to.clear();
      all.push_back({map.prepare(shape), parents[k]});
    }
    return all;
  }
  Scene scene(const std::vector<Body>& map, const std::vector<Motion>& motions) const {
    Scene scene;
    scene.end = 1;
    scene.bodies = map;
    for (std::size_t k = 0; k < links.size(); ++k) {
      scene.bodies.push_back(links[k]);
      scene.bodies.back().motion = motions[k];
      if (k > 0) scene.ignore.push_back({links[k].name, links[k].relative_to});
    }
    return scene;
  }
};

TEST(MapQueries, ChainsAsCheckSays) {
  QueryCounts counts;
  int among_links = 0;
  for (std::uint64_t seed = 2000; seed < 2000 + effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int side = rng.between(1, 4);
    const std::vector<Body> town = obstacles(rng, side);
    const StaticMap map(town, 2);
    const Arm arm(rng);
    MapQuery query(map, arm.in(map));
    for (int i = 0; i < 8; ++i) {
      SCOPED_TRACE("question " + std::to_string(i));
      std::vector<PoseSE2> from, to;
      std::vector<Motion> motions;
      for (int k = 0; k < 4; ++k) {
        const PoseSE2 joint{rng.real(0.5, 1.5), rng.real(-0.3, 0.3), rng.real(-2, 2)};
        from.push_back(k == 0 ? random_pose(rng, -3, 4.0 * side) : joint);
        to.push_back({from.back().x, from.back().y, from.back().angle + rng.real(-2, 2)});
        if (k == 0) to.back() = {from[0].x + rng.real(-2, 2), from[0].y + rng.real(-2, 2), to[0].angle};
        motions.push_back(line_of(from.back(), to.back()));
      }
      const Answer answer = check(arm.scene(town, motions));
      const MapFinding along = query.along(from, to);
      ASSERT_NO_FATAL_FAILURE(expect_agreement(along, answer, 0));
      EXPECT_EQ(query.passes(from, to).free(), along.free());
      EXPECT_EQ(query.at(from).free(), answer.outcome != Outcome::overlap_at_start);
      counts.add(along.outcome);
      if (along.other_link >= 0) ++among_links;
    }
  }
  EXPECT_GE(counts.free, static_cast<int>(enough(40)));
  EXPECT_GE(counts.contact, static_cast<int>(enough(60)));
  EXPECT_GE(among_links, static_cast<int>(enough(20)));
}

TEST(MapQueries, SlidingAndTouching) {
  Body wall;
  wall.name = "wall";
  wall.polygon = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  const StaticMap map({wall});
  Body box = wall;
  box.name = "box";
  box.polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const StaticMap::Mover mover = map.prepare(box);
  MapQuery open(map, mover);
  MapQueryOptions how;
  how.touch = Touch::closed;
  MapQuery closed(map, mover, how);
  EXPECT_TRUE(open.passes({0, 1, 0}, {3, 1, 0}).free());
  // Edges on edges all the way, which nothing but the displacement tells apart, take no longer than that takes.
  MapQueryOptions soon;
  soon.limits.max_seconds = 1;
  EXPECT_TRUE(MapQuery(map, mover, soon).passes({-1, 1, 0}, {4, 1, 0}).free());
  EXPECT_TRUE(open.at({1, 1, 0}).free());
  EXPECT_FALSE(closed.at({1, 1, 0}).free());
  EXPECT_EQ(closed.along({0, 1, 0}, {3, 1, 0}).outcome, Outcome::overlap_at_start);
  const MapFinding down = open.along({1, 2, 0}, {1, 0, 0});
  EXPECT_EQ(down.outcome, Outcome::contact);
  EXPECT_EQ(down.free_until, 0.5);
  EXPECT_EQ(down.body, 0);
  EXPECT_EQ(down.link, 0);
  EXPECT_TRUE(open.along({1, 2, 0}, {1, 2, 0}).free());
  EXPECT_EQ(open.along({1, 0.5, 0}, {1, 0.5, 0}).outcome, Outcome::overlap_at_start);
}

std::string fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(MapQueries, RefuseWhatIsNoQuestion) {
  Body wall;
  wall.name = "wall";
  wall.polygon = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  const StaticMap map({wall}), another({wall});
  const StaticMap::Mover mover = map.prepare(wall);
  EXPECT_NE(fault_of([&] { MapQuery(another, mover); }).find("another map"), std::string::npos);
  EXPECT_NE(fault_of([&] { MapQuery(map, std::vector<RobotLink>{{mover, 0}}); }).find("parent"), std::string::npos);
  EXPECT_NE(fault_of([&] { MapQuery(map, std::vector<RobotLink>{}); }).find("no link"), std::string::npos);
  MapQuery query(map, mover);
  EXPECT_NE(fault_of([&] { query.at({NAN, 0, 0}); }).find("a pose's x"), std::string::npos);
  EXPECT_NE(fault_of([&] { query.at({0, 0, INFINITY}); }).find("a pose's angle"), std::string::npos);
  const std::vector<PoseSE2> two(2);
  EXPECT_NE(fault_of([&] { query.at(two); }).find("has 1 links"), std::string::npos);
  const Motion rests;
  EXPECT_NE(fault_of([&] { query.along(std::span(&rests, 1), 1, 0); }).find("ends before it starts"),
            std::string::npos);
  std::atomic<bool> stop{true};
  MapQueryOptions how;
  how.limits.stop = &stop;
  MapQuery stopped(map, mover, how);
  Motion spin;
  spin.pieces = {{{2}, {3}, AngleRotation{{0, 100000}}}};
  const MapFinding found = stopped.along(std::span(&spin, 1), 0, 10);
  EXPECT_EQ(found.outcome, Outcome::undecided);
  EXPECT_EQ(stopped.reason(), "interrupted");
}

/// Nothing is free of what it was not tested against.
TEST(MapQueries, SayUntestedWhereNothingCanMeet) {
  Body wall, robot, hand;
  wall.name = "wall";
  wall.polygon = robot.polygon = hand.polygon = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
  wall.z = {0, 3};
  robot.z = {3, 5};
  hand.z = {2, 4};
  const StaticMap map({wall});
  MapQuery above(map, map.prepare(robot)), beside(map, map.prepare(hand));
  MapQuery two(map, {{map.prepare(robot), -1}, {map.prepare(robot), -1}});
  const PoseSE2 here, there{9, 0, 0};
  const Motion rests;
  for (int again = 0; again < 2; ++again) EXPECT_EQ(above.at(there).outcome, Outcome::untested);
  EXPECT_EQ(above.along(here, there).outcome, Outcome::untested);
  EXPECT_EQ(above.passes(here, there).outcome, Outcome::untested);
  EXPECT_EQ(above.along(std::span(&rests, 1), 0, 1).outcome, Outcome::untested);
  EXPECT_NE(above.reason().find("the only pair is on different layers"), std::string::npos) << above.reason();
  EXPECT_EQ(beside.at(here).outcome, Outcome::overlap_at_start);
  EXPECT_TRUE(beside.at(there).free());
  // Links meet each other.
  const std::vector<PoseSE2> apart{here, there};
  EXPECT_TRUE(two.at(apart).free());
}

TEST(MapQueries, OneForEachThread) {
  Rng rng(5);
  const StaticMap map(obstacles(rng, 5), 2);
  const StaticMap::Mover robot = map.prepare(star_robot(rng, "robot", 0.5));
  std::vector<PoseSE2> poses;
  for (int i = 0; i < 200; ++i) poses.push_back(random_pose(rng, -3, 20));
  const auto ask_all = [&](std::vector<double>& said) {
    MapQuery query(map, robot);
    for (std::size_t i = 1; i < poses.size(); ++i) said.push_back(query.along(poses[i - 1], poses[i]).free_until);
  };
  std::vector<double> alone, first, second;
  std::thread one([&] { ask_all(first); }), other([&] { ask_all(second); });
  one.join();
  other.join();
  ask_all(alone);
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

}  // namespace
}  // namespace taut::testing
