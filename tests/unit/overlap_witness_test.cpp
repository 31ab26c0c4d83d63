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

}  // namespace
}  // namespace taut
