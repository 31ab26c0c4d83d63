// The motion plan changes while the bodies move: the map stays, the certificates are rescheduled.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "generators/generators.hpp"
#include "support/audit.hpp"
#include "support/effort.hpp"
#include "support/prepared_scene.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"

namespace taut::testing {
namespace {

/// From the pose that `old` has at time t: a new velocity and spin. The coefficients round, so the poses differ a
/// little, which the engine must bridge.
Motion new_plan(Rng& rng, const MotionPiece& old, double t, double speed) {
  const auto value = [t](const Coefficients& c) {
    double v = 0;
    for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
    return v;
  };
  MotionPiece piece;
  const double vx = rng.real(-speed, speed), vy = rng.real(-speed, speed), w = rng.real(-1, 1);
  piece.x = {value(old.x) - vx * t, vx};
  piece.y = {value(old.y) - vy * t, vy};
  const auto* r = std::get_if<AngleRotation>(&old.rotation);
  piece.rotation = AngleRotation{{(r ? value(r->angle) : 0.0) - w * t, w}};
  return {{piece}};
}

TEST(PlanChange, MapsStayRight) {
  AuditCounts counts;
  int changes = 0;
  for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
    for (const Family family : {Family::apart, Family::intertwined, Family::nested, Family::corridor, Family::combs}) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      Rng rng(seed * 8 + static_cast<std::uint64_t>(family));
      SceneOptions options;
      options.kinds = {MotionKind::rest};
      Scene scene = random_scene(seed, family, options);
      scene.end = 16;
      for (Body& body : scene.bodies) {
        if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
        body.motion.pieces.resize(1);
        body.motion.pieces[0].until = INFINITY;
      }
      double extent = 0;
      for (const Point& v : scene.bodies[0].polygon) extent = std::max({extent, std::fabs(v.x), std::fabs(v.y)});
      TilingRun run(scene);
      MotionPiece current[2] = {scene.bodies[0].motion.pieces[0], scene.bodies[1].motion.pieces[0]};
      for (double t = 0; t < 12 && !run.finished(); t += rng.real(0.05, 0.5)) {
        while (run.step(t)) ASSERT_EQ(compare_with_static(run, counts), "");
        if (run.finished()) break;
        const int body = rng.below(2);
        const Motion plan = new_plan(rng, current[body], t, extent / 20);
        run.set_motion(body, plan);
        current[body] = plan.pieces[0];
        ++changes;
        ASSERT_EQ(compare_with_static(run, counts), "");
      }
    }
  }
  std::cout << changes << " changes, " << counts.compared << " maps compared\n";
  EXPECT_GT(changes, static_cast<int>(enough(1000)));
  EXPECT_GT(counts.compared, enough(2000));
}

/// Moves the second body of prepared shapes by steps of x, y and an angle, to and fro, one in each unit of time.
void compare_moved_on(Scene scene, Point slide, double turn, double from_angle, AuditCounts& counts) {
  scene = without_polygons(prepared(scene));
  const auto plan = [](double x, double y, double angle, Point velocity, double spin, double t) {
    MotionPiece piece;
    piece.x = {x - velocity.x * t, velocity.x};
    piece.y = {y - velocity.y * t, velocity.y};
    piece.rotation = AngleRotation{{angle - spin * t, spin}};
    return Motion{{piece}};
  };
  scene.start = 0;
  scene.end = 8;
  double x = 0, y = 0, angle = from_angle;
  scene.bodies[1].motion = plan(x, y, angle, {}, 0, 0);
  TilingRun run(scene);
  for (int k = 0; k < 8; ++k) {
    const double sign = k % 4 < 2 ? 1 : -1;
    run.set_motion(1, plan(x, y, angle, {sign * slide.x, sign * slide.y}, sign * turn, k));
    while (run.step(k + 1)) {
    }
    ASSERT_FALSE(run.answer().contact) << "on the way to pose " << k + 1;
    x += sign * slide.x, y += sign * slide.y, angle += sign * turn;
    if (k < 7) {
      ASSERT_EQ(compare_with_static(run, counts), "") << "at pose " << k + 1;
    }
  }
}

/// Questions from starts that have moved a little: going on is the same as beginning anew.
TEST(PlanChange, GoesOnToThePosesOfLargePreparedShapes) {
  AuditCounts counts;
  gen::CombOptions combs;
  combs.teeth = static_cast<int>(effort(1024));
  for (const double share : {0.01, 0.3}) compare_moved_on(gen::make_combs(combs), {0.1 * share, 0.03}, 0, 0, counts);
  gen::SpiralOptions spiral;
  spiral.side_points = std::max(100, static_cast<int>(effort(2048)));
  for (const double turn : {0.001, 0.1}) compare_moved_on(gen::make_spiral(spiral), {}, turn, 1.7, counts);
  EXPECT_GT(counts.compared, 20u);
}

Scene two_squares() {
  Scene scene;
  scene.start = 0;
  scene.end = 100;
  scene.bodies = {{"a", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, {"b", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};
  scene.bodies[1].motion.pieces = {{{3, -0.5}, {0.25}, NoRotation{}}};
  return scene;
}

TEST(PlanChange, TurningBackInTime) {
  Simulation simulation(two_squares());
  EXPECT_EQ(simulation.advance_to(2), SimulationState::running);
  EXPECT_EQ(simulation.time(), 2);
  simulation.set_motion(1, {{{{1, 0.5}, {0.25}, NoRotation{}}}});
  EXPECT_EQ(simulation.advance_to(1000), SimulationState::finished);
  EXPECT_EQ(simulation.time(), 100);
}

TEST(PlanChange, GoingOnHits) {
  Simulation simulation(two_squares());
  EXPECT_EQ(simulation.advance_to(1000), SimulationState::contact);
  ASSERT_TRUE(simulation.contact());
  EXPECT_NEAR(simulation.contact()->time.lo, 4, 1e-12);
  EXPECT_FALSE(simulation.step());
}

TEST(PlanChange, OfOneBodyWhileTheOtherIsInALaterPiece) {
  Scene scene = two_squares();
  // Until t = 1 it comes nearer, then it goes up, and back from t = 3: never closer than 1.5.
  scene.bodies[1].motion.pieces = {
      {{3, -0.5}, {0}, NoRotation{}, 1}, {{2.5}, {-1, 1}, NoRotation{}, 3}, {{2.5}, {2}, NoRotation{}}};
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance_to(2), SimulationState::running);
  // The other one at rest sets off to where it will be.
  simulation.set_motion(0, {{{{-1, 0.5}, {0}, NoRotation{}}}});
  EXPECT_EQ(simulation.advance_to(4), SimulationState::running);
  simulation.set_motion(0, {{{{-1, 0.5}, {-4, 1}, NoRotation{}}}});
  EXPECT_EQ(simulation.advance_to(1000), SimulationState::contact);
  // Its right side at 0.5 t meets x = 2.5; it is at y = t - 4 = 1 then, and overlaps [2, 3] from t = 5 on.
  ASSERT_TRUE(simulation.contact());
  EXPECT_NEAR(simulation.contact()->time.lo, 5, 1e-9);
}

TEST(PlanChange, BetweenEventsThatNearlyCoincide) {
  // All teeth of a comb reach those of the other at once: after the first event, the others are due.
  Scene scene;
  scene.start = 0;
  scene.end = 8;
  Polygon comb = {{0, 0}};
  for (int tooth = 0; tooth < 4; ++tooth) {
    const double x = 2 * tooth;
    comb.insert(comb.end(), {{x, 3}, {x + 1, 3}, {x + 1, 1}, {x + 2, 1}});
  }
  comb.insert(comb.end(), {{9, 0}});
  scene.bodies = {{"a", comb, {}}, {"b", comb, {}}};
  for (Point& v : scene.bodies[1].polygon) v = {9.5 - v.x, -v.y};
  scene.bodies[1].motion.pieces = {{{}, {9, -1}, NoRotation{}}};
  const Answer whole = check(scene);
  ASSERT_EQ(whole.outcome, Outcome::contact);
  Simulation simulation(scene);
  int changes = 0;
  double last = simulation.time();
  while (simulation.step()) {
    EXPECT_GE(simulation.time(), last);
    last = simulation.time();
    if (simulation.state() != SimulationState::running) break;
    simulation.set_motion(0, {});
    simulation.set_motion(1, scene.bodies[1].motion);
    ++changes;
  }
  EXPECT_GT(changes, 0);
  ASSERT_TRUE(simulation.contact());
  EXPECT_NEAR(simulation.contact()->time.lo, whole.contact->time.lo, 1e-9);
}

TEST(PlanChange, AdvanceStandsAtTheTimeThatWasAsked) {
  // One square slides along the top of the other; corners are on one line at t = 4, in enclosures that reach beyond.
  Scene scene = two_squares();
  scene.end = 12;
  scene.bodies[1].motion.pieces = {{{4, -1}, {1}, NoRotation{}}};
  Simulation simulation(scene);
  EXPECT_EQ(simulation.advance_to(4), SimulationState::running);
  EXPECT_GT(simulation.events(), 0u);
  EXPECT_EQ(simulation.time(), 4);
  // From here on it comes down.
  simulation.set_motion(1, {{{{0}, {5, -1}, NoRotation{}}}});
  EXPECT_EQ(simulation.advance_to(12), SimulationState::contact);
  ASSERT_TRUE(simulation.contact());
  EXPECT_LE(simulation.contact()->time.hi, 4.0000000000000018);
}

TEST(PlanChange, AJumpIsRefusedAndChangesNothing) {
  Simulation simulation(two_squares());
  simulation.advance_to(2);
  try {
    simulation.set_motion(1, {{{{2.5}, {0.25}, NoRotation{}}}});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("jumps by 0.5"), std::string::npos) << e.what();
  }
  EXPECT_EQ(simulation.advance_to(1000), SimulationState::contact);
  EXPECT_NEAR(simulation.contact()->time.lo, 4, 1e-12);
}

}  // namespace
}  // namespace taut::testing
