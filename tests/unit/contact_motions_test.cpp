// What bodies do at a contact: stop, give way, follow a cam.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/check.hpp"
#include "taut/contact_motions.hpp"
#include "taut/error.hpp"
#include "taut/follow.hpp"
#include "taut/io.hpp"
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

/// A round cam turns under a face that is drawn where it touches: whether they touch is finer than doubles resolve
/// curves there, and what is asked about one instant leaves nothing behind for the next one.
TEST(ContactMotions, AFaceRestsOnARoundCam) {
  const Scene scene = parse_scene(R"({"format": "taut-scene/1", "time": [0, 360], "bodies": [
    {"name": "cam", "polygon": {"path": "M10 0 A10 10 0 0 1 -10 0 L-10 -14 L10 -14 Z"},
     "motion": {"velocity": [0, 0], "spin_deg": 1}},
    {"name": "face", "polygon": [[-6, 10], [6, 10], [6, 12], [-6, 12]]}]})");
  const FollowAnswer answer = follow(scene, 1, {0, 1}, 20, {36});
  EXPECT_FALSE(answer.undecided.empty());
  EXPECT_GE(answer.lifts.size(), 12U);
  for (const Lift& lift : answer.lifts) EXPECT_GE(lift.lift[1], 0);
}

std::vector<FollowStretch> contacts_of(const Scene& scene, BodyId follower, Touch touch = Touch::open) {
  FollowOptions options;
  options.instants = 1;
  options.contacts = true;
  options.touch = touch;
  const FollowAnswer answer = follow(scene, follower, {0, 1}, 20, options);
  EXPECT_EQ(answer.contacts_reason, "");
  EXPECT_EQ(answer.contacts.front().time.lo, scene.start);
  EXPECT_EQ(answer.contacts.back().time.hi, scene.end);
  for (std::size_t k = 1; k < answer.contacts.size(); ++k)
    EXPECT_EQ(answer.contacts[k - 1].time.hi, answer.contacts[k].time.lo);
  return answer.contacts;
}

std::string states_of(const std::vector<FollowStretch>& contacts) {
  std::string text;
  for (const FollowStretch& s : contacts) text += to_string(s.state)[0];
  return text;
}

/// The corners of a square that turns hold a plate in turn. At quarter turns an edge lies on the plate, for an instant.
TEST(ContactMotions, CornersHoldAPlateInTurn) {
  Scene scene;
  scene.start = 0.5;
  scene.end = 4.5;
  scene.bodies = {{"cam", rectangle(-1, -1, 2, 2), from_velocity({0, 0}, 90)}, {"plate", rectangle(-3, 1, 6, 0.5), {}}};
  const std::vector<FollowStretch> contacts = contacts_of(scene, 1);
  ASSERT_EQ(states_of(contacts), "ccccccccc");
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const FollowStretch& s = contacts[k];
    ASSERT_EQ(s.state, k % 2 == 0 ? FollowState::carried : FollowState::change);
    if (s.state == FollowState::change) {
      EXPECT_TRUE(s.once);
      EXPECT_FALSE(s.jumps);
      EXPECT_LE(s.time.hi - s.time.lo, 4e-9);
      EXPECT_LE(s.time.lo, 0.5 + static_cast<double>(k) / 2);
      EXPECT_GE(s.time.hi, 0.5 + static_cast<double>(k) / 2);
      continue;
    }
    ASSERT_EQ(s.contacts.size(), 1U);
    EXPECT_EQ(s.contacts[0].vertex, (VertexRef{0, static_cast<int>(6 - k / 2) % 4}));
    EXPECT_EQ(s.contacts[0].edge, (EdgeRef{1, 0}));
  }
}

/// A table goes away under a block: an edge lies on an edge all the time, and then the block falls, once.
TEST(ContactMotions, AFollowerFallsOffATable) {
  Scene scene;
  scene.end = 4;
  MotionPiece away;
  away.x = {-0.5, -1};
  scene.bodies = {{"table", rectangle(-2, 0, 4, 3), {{away}}}, {"block", rectangle(-1, 1, 2, 1), {}}};
  const std::vector<FollowStretch> contacts = contacts_of(scene, 1);
  // Its left end comes under the block never: until it has left, the table's right end and the block's left one touch.
  ASSERT_EQ(contacts.back().state, FollowState::low);
  const FollowStretch& falls = contacts[contacts.size() - 2];
  EXPECT_EQ(falls.state, FollowState::change);
  EXPECT_TRUE(falls.once);
  EXPECT_TRUE(falls.jumps);
  EXPECT_LE(falls.time.lo, 2.5);
  EXPECT_GE(falls.time.hi, 2.5);
  for (const FollowStretch& s : contacts) {
    if (s.state != FollowState::carried) continue;
    EXPECT_EQ(s.contacts.size(), 2U);
    EXPECT_LE(s.lift[0], 2);
    EXPECT_GE(s.lift[1], 2);
    EXPECT_LT(s.lift[1] - s.lift[0], 1e-12);
  }
}

/// A block as wide as the gap between walls comes down on a step. Its sides slide along the walls, which is no contact
/// of open bodies; of closed ones, its lower corners meet the walls' upper ones before.
TEST(ContactMotions, SidesAlongTheDirectionHoldNothing) {
  Scene scene;
  scene.end = 1;
  MotionPiece up;
  up.y = {0.25, 0.5};
  scene.bodies = {{"step", rectangle(-1, 0, 2, 1), {{up}}},
                  {"left", rectangle(-2, 0, 1, 5), {}},
                  {"right", rectangle(1, 0, 1, 5), {}},
                  {"block", rectangle(-1, 1, 2, 1), {}}};
  const std::vector<FollowStretch> open = contacts_of(scene, 3);
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].state, FollowState::carried);
  EXPECT_EQ(open[0].contacts.size(), 4U);
  EXPECT_TRUE(std::all_of(open[0].contacts.begin(), open[0].contacts.end(), [](const FollowContact& c) {
    return (c.vertex.body == 0 && c.edge.body == 3) || (c.vertex.body == 3 && c.edge.body == 0);
  }));
  const std::vector<FollowStretch> closed = contacts_of(scene, 3, Touch::closed);
  ASSERT_EQ(closed.size(), 1U);
  EXPECT_EQ(closed[0].state, FollowState::carried);
  EXPECT_TRUE(std::all_of(closed[0].contacts.begin(), closed[0].contacts.end(),
                          [](const FollowContact& c) { return c.vertex.body != 0 && c.edge.body != 0; }));
}

TEST(ContactMotions, ContactsOfFollowersHaveLimits) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"cam", rectangle(-1, -1, 2, 2), from_velocity({0, 0}, 90)}, {"plate", rectangle(-3, 1, 6, 0.5), {}}};
  FollowOptions options;
  options.contacts = true;
  options.limits.max_seconds = 0;
  const FollowAnswer stopped = follow(scene, 1, {0, 1}, 2, options);
  EXPECT_EQ(states_of(stopped.contacts), "o");
  EXPECT_NE(stopped.contacts_reason, "");
  options.limits = {};
  options.tolerance = 0;
  EXPECT_THROW(follow(scene, 1, {0, 1}, 2, options), InputError);
  options.tolerance = 1e-9;
  // A bar comes to where the follower is lifted to, later.
  scene.bodies.push_back({"bar", rectangle(5, 3, 4, 0.5), from_velocity({-9, 0})});
  EXPECT_THROW(follow(scene, 1, {0, 1}, 2, options), InputError);
}

}  // namespace
}  // namespace taut::testing
