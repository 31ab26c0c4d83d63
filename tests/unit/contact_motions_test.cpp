// What bodies do at a contact: stop, give way, follow a cam.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/check.hpp"
#include "taut/contact_motions.hpp"
#include "taut/error.hpp"
#include "taut/follow.hpp"
#include "taut/motions.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
namespace {

Polygon rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

SimulationOptions recorded() {
  SimulationOptions options;
  options.record = true;
  return options;
}

TEST(ContactMotions, ABodyStops) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"car", rectangle(0, 0, 2, 1), Motion{{{{0, 1}, {0, 0.125}, AngleRotation{{0, 0.1}}}}}},
                  {"wall", rectangle(6, -5, 1, 20), {}}};
  Simulation simulation(scene, recorded());
  EXPECT_THROW(stop(simulation, 0), InputError);
  ASSERT_EQ(simulation.advance_to(10), SimulationState::contact);
  const BodyPose before = poses_at(simulation.scene(), simulation.time())[0];
  stop(simulation, 0);
  simulation.resume();
  EXPECT_EQ(simulation.advance_to(10), SimulationState::finished);
  const BodyPose after = poses_at(simulation.scene(), 10)[0];
  EXPECT_NEAR(after.origin.x, before.origin.x, 1e-11);
  EXPECT_NEAR(after.origin.y, before.origin.y, 1e-11);
  EXPECT_NEAR(after.axis.y, before.axis.y, 1e-11);
  EXPECT_EQ(check(simulation.record()[0]).outcome, Outcome::free);
}

/// The opener's corner, at (x, 1), touches the door, which is hinged at (4, 4) and hangs down from there: the least
/// angle is known at all times.
TEST(ContactMotions, ADoorIsPushedOpen) {
  Scene scene;
  scene.end = 5;
  scene.bodies = {{"opener", rectangle(0, 0, 1, 1), from_velocity({1, 0})},
                  {"door", rectangle(4, 0.25, 0.25, 3.75), {}}};
  const Guide guide{Point{4, 4}, {}};
  for (const double step : {0.25, 0.03125}) {
    Simulation simulation(scene, recorded());
    int contacts = 0;
    for (; simulation.advance_to(5) == SimulationState::contact && contacts < 10000; ++contacts) {
      EXPECT_FALSE(simulation.contact_again());
      const BodyPose door = poses_at(simulation.scene(), simulation.time())[1];
      const double angle = std::atan2(door.axis.y, door.axis.x), x = 1 + simulation.time();
      // The corner is on the door's left face, a line through the hinge.
      EXPECT_NEAR((x - 4) * std::cos(angle) + (1 - 4.0) * std::sin(angle), 0, 1e-10);
      push(simulation, 1, guide, step);
      simulation.resume();
    }
    EXPECT_EQ(simulation.state(), SimulationState::finished) << simulation.reason();
    EXPECT_EQ(check(simulation.record()[0]).outcome, Outcome::free);
    const BodyPose door = poses_at(simulation.scene(), 5)[1];
    const double angle = std::atan2(door.axis.y, door.axis.x), least = std::atan2(2, 3);
    EXPECT_GE(angle, least);
    EXPECT_LE(angle, least + step / 2);
    EXPECT_GE(contacts, 1.5 / step);
    EXPECT_LE(contacts, 2 / step + 1);
  }
}

TEST(ContactMotions, ABlockIsPushedAlong) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"pusher", rectangle(0, 0, 1, 1), from_velocity({1, 0})}, {"block", rectangle(3, 0.25, 1, 1), {}}};
  Simulation simulation(scene, recorded());
  ASSERT_EQ(simulation.advance_to(10), SimulationState::contact);
  EXPECT_THROW(push(simulation, 1, Guide{std::nullopt, {0, 1}}, 1), InputError);
  EXPECT_THROW(push(simulation, 1, Guide{}, 1), InputError);
  EXPECT_THROW(push(simulation, 1, Guide{std::nullopt, {1, 0}}, 0), InputError);
  while (simulation.advance_to(10) == SimulationState::contact) {
    EXPECT_NEAR(poses_at(simulation.scene(), simulation.time())[1].origin.x, simulation.time() - 2, 1e-9);
    push(simulation, 1, Guide{std::nullopt, {2, 0}}, 0.75);
    simulation.resume();
  }
  EXPECT_EQ(simulation.state(), SimulationState::finished) << simulation.reason();
  EXPECT_GE(simulation.contacts(), 10u);
  EXPECT_EQ(check(simulation.record()[0]).outcome, Outcome::free);
}

/// A square that turns about its centre, under a flat plate: the lift is that of the highest corner.
TEST(ContactMotions, AFollowerLiesOnACam) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"cam", rectangle(-1, -1, 2, 2), from_velocity({0, 0}, 90)}, {"plate", rectangle(-3, 1, 6, 0.5), {}}};
  const FollowAnswer answer = follow(scene, 1, {0, 3}, 2, {100});
  const std::vector<Lift>& lifts = answer.lifts;
  EXPECT_EQ(answer.coverage.pairs, 1U);
  EXPECT_EQ(answer.coverage.tested, 1U);
  ASSERT_EQ(lifts.size(), 100u);
  for (const Lift& lift : lifts) {
    const double angle = std::numbers::pi / 2 * lift.time.lo;
    const double top = std::sqrt(2.0) * std::cos(angle - std::numbers::pi / 4) - 1;
    EXPECT_NEAR(lift.lift[0], top, 1e-12);
    EXPECT_LE(lift.lift[0], lift.lift[1]);
    EXPECT_LT(lift.lift[1] - lift.lift[0], 1e-12);
    EXPECT_EQ(lift.vertex.body, 0);
    EXPECT_EQ(lift.vertex.index, 2);
    EXPECT_EQ(lift.edge.body, 1);
  }
  EXPECT_THROW(follow(scene, 1, {0, 1}, 0.2, {10}), InputError);
  EXPECT_THROW(follow(scene, 2, {0, 1}, 1, {10}), InputError);
  EXPECT_THROW(follow(scene, 0, {0, 1}, 9, {10}), InputError);
  // Two more bodies, of which one is ignored: it is said, and of nothing else nothing is.
  scene.bodies.push_back({"lid", rectangle(-3, 9, 6, 0.5), {}});
  scene.bodies.push_back({"pin", rectangle(-3, 1.1, 1, 0.1), {}});
  scene.ignore = {{"plate", "pin"}};
  const Coverage coverage = follow(scene, 1, {0, 1}, 2, {10}).coverage;
  EXPECT_EQ(coverage.pairs, 3U);
  EXPECT_EQ(coverage.ignored, 1U);
  EXPECT_EQ(coverage.tested, 1U);
  EXPECT_EQ(coverage.apart, 1U);
  scene.ignore = {{"plate", "*"}};
  EXPECT_THROW(follow(scene, 1, {0, 1}, 2, {10}), InputError);
}

/// A bar comes in over the follower while it comes down: what lies on it then is not below the bar.
TEST(ContactMotions, AFollowerLiesOnWhatPassesOverIt) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"bar", {{-30, 3}, {-20, 3}, {-16, 6}, {-16, 7}, {-30, 7}}, from_velocity({3, 0})},
                  {"square", rectangle(0, 0, 1, 1), {}}};
  for (const double reach : {7.5, 8.0, 9.0}) {
    for (const std::size_t instants : {1U, 7U, 40U}) {
      for (const Lift& at : follow(scene, 1, {0, 1}, reach, {instants}).lifts) {
        // The bar is above the square from 16 / 3 on, and its tip reaches it.
        EXPECT_GT(at.time.hi, 16.0 / 3);
        EXPECT_LE(at.lift[0], 7);
        EXPECT_GE(at.lift[1], 7);
      }
    }
  }
}

}  // namespace
}  // namespace taut::testing
