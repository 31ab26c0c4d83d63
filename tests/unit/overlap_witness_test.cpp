// Bodies that overlap at the start: the point that shows it, judged by rational arithmetic.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "support/random_scenes.hpp"
#include "taut/check.hpp"
#include "taut/motions.hpp"
#include "taut/simulation.hpp"

namespace taut {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// -1 outside, 0 on the boundary, 1 inside, for a body at rest moved by `shift`, which is added exactly.
int where(const Point& point, const Polygon& polygon, const Point& shift) {
  const Rational x = Rational(point.x) - Rational(shift.x), y = Rational(point.y) - Rational(shift.y);
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational ax(a.x), ay(a.y), bx(b.x), by(b.y);
    const Rational side = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    const bool beside = (ax < x && bx < x) || (ax > x && bx > x) || (ay < y && by < y) || (ay > y && by > y);
    if (side == 0 && !beside) return 0;
    if ((ay > y) != (by > y) && (side > 0) == (by > ay)) inside = !inside;
  }
  return inside ? 1 : -1;
}

Scene of_two(const Polygon& p, const Polygon& q, const Motion& motion = {}) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"p", p, {}}, {"q", q, motion}};
  return scene;
}

Polygon box_body(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// The same from all who answer.
std::optional<Point> witness_of(const Scene& scene, Touch touch) {
  CheckOptions options;
  options.touch = touch;
  const Answer kinetic = check(scene, options);
  options.engine = EngineChoice::spacetime;
  const Answer spacetime = check(scene, options);
  const Simulation simulation(scene, touch);
  EXPECT_EQ(kinetic.outcome, Outcome::overlap_at_start);
  EXPECT_EQ(spacetime.outcome, Outcome::overlap_at_start);
  EXPECT_EQ(simulation.state(), SimulationState::overlap_at_start);
  EXPECT_EQ(kinetic.overlap_point, spacetime.overlap_point);
  EXPECT_EQ(kinetic.overlap_point, simulation.overlap_point());
  return kinetic.overlap_point;
}

void expect_inside(const Scene& scene, const Point& shift, const char* what) {
  for (const Touch touch : {Touch::open, Touch::closed}) {
    const std::optional<Point> point = witness_of(scene, touch);
    ASSERT_TRUE(point) << what;
    EXPECT_EQ(where(*point, scene.bodies[0].polygon, {}), 1) << what;
    EXPECT_EQ(where(*point, scene.bodies[1].polygon, shift), 1) << what;
  }
}

TEST(OverlapWitness, LiesInsideBothBodies) {
  expect_inside(of_two(box_body(0, 0, 2, 2), box_body(1, 1, 3, 3)), {}, "corners");
  expect_inside(of_two(box_body(0, 0, 8, 8), box_body(3, 3, 4, 4)), {}, "one inside the other");
  expect_inside(of_two(box_body(3, 3, 4, 4), box_body(0, 0, 8, 8)), {}, "the other way round");
  expect_inside(of_two(box_body(0, 0, 1, 9), box_body(-4, 4, 5, 5)), {}, "a cross");
  expect_inside(of_two(box_body(0, 0, 1, 1), box_body(0, 0, 1, 1)), {}, "the same");
  const Motion away{{{{4, 1}, {-0.1}, NoRotation{}}}};
  expect_inside(of_two(box_body(0, 0, 2, 2), box_body(-3, 1, -2.5, 7), away), {4, -0.1}, "moved");
}

/// Between the lines that are looked along first: beside the edges that cross.
TEST(OverlapWitness, IsFoundInATinyCornerOfALongOverlap) {
  const Polygon needle{{-1e-7, 4.1}, {-9, 0}, {-9, 9}};
  expect_inside(of_two(box_body(-1e-7 - 1e-9, -90, 90, 90), needle), {}, "a tip");
  const Polygon comb{{100, -50}, {100, 50}, {0, 50}, {0, -49}, {-1e-9, -49.00001}, {0, -49.00002}, {0, -50}};
  expect_inside(of_two(comb, box_body(-100, -50, -5e-10, 50)), {}, "a tooth");
}

TEST(OverlapWitness, IsThereAsLongAsADoubleLiesInBoth) {
  expect_inside(of_two(box_body(0, 0, 1, 1), box_body(1 - 0x1p-52, 0, 2, 1)), {}, "one double between them");
  const Scene none = of_two(box_body(0, 0, 1, 1), box_body(1 - 0x1p-53, 0, 2, 1));
  EXPECT_FALSE(witness_of(none, Touch::open));
  EXPECT_FALSE(witness_of(none, Touch::closed));
}

TEST(OverlapWitness, OfTurnedBodiesIsInsideByMoreThanTheTurnIsRoundedBy) {
  for (int k = 0; k < 24; ++k) {
    const Motion turned = from_velocity({0, 0}, 15, {});
    Scene scene = of_two(box_body(0, 0, 4, 1), box_body(-2, -2, 2, 2), turned);
    scene.start = k;
    scene.end = k + 1;
    const std::optional<Point> point = witness_of(scene, Touch::open);
    ASSERT_TRUE(point);
    EXPECT_EQ(where(*point, scene.bodies[0].polygon, {}), 1);
    const double angle = -15.0 * k * std::acos(-1.0) / 180, c = std::cos(angle), s = std::sin(angle);
    EXPECT_LT(std::fabs(c * point->x - s * point->y), 2 + 1e-12) << k;
    EXPECT_LT(std::fabs(s * point->x + c * point->y), 2 + 1e-12) << k;
  }
}

TEST(OverlapWitness, IsNotThereWhereBodiesOnlyTouch) {
  const Scene scene = of_two(box_body(0, 0, 1, 1), box_body(1, 0, 2, 1));
  CheckOptions options;
  options.touch = Touch::closed;
  const Answer answer = check(scene, options);
  EXPECT_EQ(answer.outcome, Outcome::contact);
  EXPECT_FALSE(answer.overlap_point);
}

/// Random bodies pushed into each other.
TEST(OverlapWitness, IsFoundForRandomPolygons) {
  int overlaps = 0;
  for (int seed = 0; seed < 60; ++seed) {
    Scene scene = testing::random_scene(31000 + static_cast<std::uint64_t>(seed), testing::Family::intertwined);
    scene.bodies[0].motion = {};
    scene.bodies[1].motion = {};
    const auto middle = [](const Polygon& polygon) { return polygon[0]; };
    const Point a = middle(scene.bodies[0].polygon), b = middle(scene.bodies[1].polygon);
    const Point shift{a.x - b.x, a.y - b.y};
    scene.bodies[1].motion = Motion{{{{shift.x}, {shift.y}, NoRotation{}}}};
    if (check(scene).outcome != Outcome::overlap_at_start) continue;
    ++overlaps;
    expect_inside(scene, shift, "random");
  }
  EXPECT_GT(overlaps, 20);
}

/// -1 outside, 0 on the boundary of a part, 1 inside one, for a body at rest.
int where(const Point& point, const Body& body) {
  int best = -1;
  for (const Part& part : body.parts.empty() ? std::vector<Part>{{body.polygon, {}}} : body.parts) {
    int here = where(point, part.outline, {});
    for (const Polygon& hole : part.holes) here = std::min(here, -where(point, hole, {}));
    best = std::max(best, here);
  }
  return best;
}

std::optional<Point> world_feature_map(const Scene& scene) {
  std::optional<Point> found;
  for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::both}) {
    for (const Touch touch : {Touch::open, Touch::closed}) {
      CheckOptions options;
      options.engine = engine;
      options.touch = touch;
      const Answer answer = check(scene, options);
      EXPECT_EQ(answer.outcome, Outcome::overlap_at_start);
      if (found) {
        EXPECT_EQ(answer.overlap_point, found);
      }
      found = answer.overlap_point;
    }
  }
  return found;
}

Body of_parts(const std::string& name, const std::vector<Part>& parts) {
  Body body;
  body.name = name;
  body.parts = parts;
  return body;
}

/// Neither holes nor other parts count as inside.
TEST(OverlapWitness, OfBodiesOfRingsLiesInAPartOfEach) {
  const Body frame =
      of_parts("frame", {{box_body(0, 0, 10, 10), {box_body(1, 1, 9, 9)}}, {box_body(20, 0, 21, 1), {}}});
  const Body plug = of_parts("plug", {{box_body(8, 4, 9.5, 6), {box_body(8.5, 4.5, 9.25, 5.5)}}});
  const Body far =
      of_parts("far", {{box_body(-9, -9, -8, -8), {}}, {box_body(20.5, 0.5, 30, 2), {box_body(22, 1, 23, 1.5)}}});
  const Body inside = of_parts("inside", {{box_body(0.25, 0.25, 0.5, 0.5), {}}});
  for (const Body& other : {plug, far, inside}) {
    for (const bool swapped : {false, true}) {
      Scene scene;
      scene.end = 1;
      scene.bodies = {frame, other, Body{"away", box_body(100, 100, 101, 101), from_velocity({1, 0}, 0)}};
      scene.bodies[1].motion = from_velocity({1, 0}, 0);
      if (swapped) std::swap(scene.bodies[0], scene.bodies[1]);
      const std::optional<Point> point = world_feature_map(scene);
      ASSERT_TRUE(point) << other.name;
      EXPECT_EQ(where(*point, frame), 1) << other.name;
      EXPECT_EQ(where(*point, other), 1) << other.name;
    }
  }
}

TEST(OverlapWitness, OfABodyWithAParentIsWhereItsParentPutsIt) {
  Scene scene;
  scene.end = 1;
  Body hand = of_parts("hand", {{box_body(5, -1, 7, 1), {}}});
  hand.relative_to = "arm";
  scene.bodies = {Body{"arm", box_body(0, -1, 4, 1), from_sweep({0, 0}, 90, 120, 0, 1)}, hand,
                  Body{"ceiling", box_body(-10, 6, 10, 8), {}}};
  const std::optional<Point> point = world_feature_map(scene);
  ASSERT_TRUE(point);
  EXPECT_EQ(where(*point, scene.bodies[2]), 1);
  EXPECT_LT(std::fabs(point->x), 1 + 1e-12);
  EXPECT_GT(point->y, 6);
  EXPECT_LT(point->y, 7 + 1e-12);
}

}  // namespace
}  // namespace taut
