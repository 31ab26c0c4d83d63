// Simulations that go on after contacts: what they record is free, and asked afresh, it has the same contacts.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "generators/generators.hpp"
#include "support/effort.hpp"
#include "support/large_world.hpp"
#include "support/made_world.hpp"
#include "support/responses.hpp"
#include "support/simulated_run.hpp"
#include "support/simulated_worlds.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
namespace {

struct RunCounts {
  int contacts = 0, again = 0, finished = 0, changes = 0, scenes = 0, several = 0;
};

/// The next stop is where the rest of the scene, asked about by the other engine, comes to.
void expect_same(const Simulation& simulation, const Answer& answer, double from) {
  if (answer.outcome == Outcome::free || answer.outcome == Outcome::untested) {
    ASSERT_TRUE(simulation.state() == SimulationState::finished || simulation.state() == SimulationState::untested)
        << to_string(simulation.state()) << " at " << simulation.time() << ' ' << simulation.reason();
    return;
  }
  ASSERT_EQ(simulation.state(), SimulationState::contact) << simulation.reason();
  const Contact& found = *simulation.contact();
  if (answer.outcome == Outcome::overlap_at_start) {
    // By the rounding of new motions, which are followed from the old ones.
    ASSERT_EQ(found.time.lo, from);
    return;
  }
  ASSERT_EQ(answer.outcome, Outcome::contact) << answer.reason;
  ASSERT_NEAR(found.time.lo, answer.contact->time.lo, 1e-9);
  ASSERT_NEAR(found.time.hi, answer.contact->time.hi, 1e-9);
  ASSERT_LE(simulation.time(), found.time.hi);
}

void expect_record_is_free(const Simulation& simulation, Touch touch, RunCounts& counts) {
  double until = 0;
  for (const Scene& scene : simulation.record()) {
    ++counts.scenes;
    until = scene.end;
    const Answer answer = fresh_answer(scene, touch);
    ASSERT_TRUE(answer.outcome == Outcome::free || answer.outcome == Outcome::untested)
        << to_string(answer.outcome) << (answer.contact ? " at " + std::to_string(answer.contact->time.lo) : "");
  }
  EXPECT_EQ(until, simulation.time());
}

/// From contact to contact, and changes of plan between them.
void run(const Scene& scene, Touch touch, Rng& rng, int contacts, RunCounts& counts) {
  SimulationOptions options;
  options.touch = touch;
  options.record = true;
  Simulation simulation(scene, options);
  if (simulation.state() == SimulationState::overlap_at_start) return;
  for (int k = 0; k < contacts; ++k) {
    const double from = simulation.time();
    const Answer answer = asked_afresh(simulation, touch);
    if (answer.outcome == Outcome::undecided) return;
    simulation.advance_to(scene.end);
    ASSERT_NO_FATAL_FAILURE(expect_same(simulation, answer, from)) << "contact " << k;
    if (simulation.state() != SimulationState::contact) {
      ++counts.finished;
      break;
    }
    ++counts.contacts;
    counts.again += simulation.contact_again();
    counts.several += !simulation.also().empty();
    // A contact at the start has no time before it in which bodies could part.
    if (simulation.time() == scene.start) return;
    part_all(simulation, rng);
    simulation.resume();
  }
  ASSERT_NO_FATAL_FAILURE(expect_record_is_free(simulation, touch, counts));
}

TEST(ResumedSimulation, GoesWhereTheRestOfTheSceneGoes) {
  RunCounts counts;
  for (std::uint64_t seed = 0; seed < effort(500); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed + 17);
    const Scene scene = scene_of(seed % 5 == 0 ? large_world(seed).world : random_world(seed + 20000));
    ASSERT_NO_FATAL_FAILURE(run(scene, seed % 3 == 2 ? Touch::closed : Touch::open, rng, 12, counts));
  }
  std::cout << counts.contacts << " contacts, " << counts.again << " again, " << counts.several << " of several pairs, "
            << counts.finished << " ends, " << counts.scenes << " recorded scenes\n";
  EXPECT_GE(counts.contacts, static_cast<int>(enough(500)));
}

/// All calls there are, in any order; every fifth world has up to 60 bodies.
TEST(ResumedSimulation, AnySequenceOfCallsComesToWhatTheRestOfTheSceneComesTo) {
  RunTally tally;
  for (std::uint64_t seed = 0; seed < effort(600); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = scene_of(seed % 5 == 0 ? large_world(seed).world : random_world(seed + 30000));
    ASSERT_EQ(wrong_with_run(seed, scene, seed % 3 == 2 ? Touch::closed : Touch::open, 40, tally), "");
  }
  std::cout << tally.calls << " calls, " << tally.refused << " refused, " << tally.contacts << " contacts, "
            << tally.again << " again, " << tally.several << " of several pairs, " << tally.ends << " ends, "
            << tally.scenes << " recorded scenes\n";
  EXPECT_GE(tally.contacts, static_cast<int>(enough(500)));
  EXPECT_GE(tally.again, static_cast<int>(enough(20)));
}

/// A ball between two walls: the contacts are known.
Scene corridor() {
  Scene scene;
  scene.end = 20;
  scene.bodies = {
      {"ball", {{-0.5, 0}, {0, -0.5}, {0.5, 0}, {0, 0.5}}, from_keyframes({{0, 2, 0, 0}, {100, 302, 0, 0}})},
      {"left", {{-1, -5}, {0, -5}, {0, 5}, {-1, 5}}, {}},
      {"right", {{10, -5}, {11, -5}, {11, 5}, {10, 5}}, {}}};
  return scene;
}

Motion linear(double t, double x, double v, double y = 0, double w = 0) {
  MotionPiece piece;
  piece.x = {x, v};
  piece.y = {y, w};
  piece.origin = t;
  return Motion{{piece}};
}

TEST(ResumedSimulation, ABallGoesToAndFro) {
  SimulationOptions options;
  options.record = true;
  Simulation simulation(corridor(), options);
  double x = 9.5, v = -3;
  int bounces = 0;
  while (simulation.advance_to(20) == SimulationState::contact) {
    EXPECT_FALSE(simulation.contact_again());
    EXPECT_NEAR(simulation.time(), 2.5 + 3 * bounces, 1e-12);
    EXPECT_EQ((*simulation.pair())[1], bounces % 2 ? 1 : 2);
    simulation.set_motion(0, linear(simulation.time(), x, v));
    EXPECT_EQ(simulation.state(), SimulationState::contact);
    EXPECT_EQ(simulation.resume(), SimulationState::running);
    x = 10 - x;
    v = -v;
    ++bounces;
  }
  EXPECT_EQ(bounces, 6);
  EXPECT_EQ(simulation.contacts(), 6u);
  EXPECT_EQ(simulation.state(), SimulationState::finished);
  ASSERT_EQ(simulation.record().size(), 1u);
  EXPECT_EQ(check(simulation.record()[0]).outcome, Outcome::free);
}

TEST(ResumedSimulation, SaysThatAContactComesAgain) {
  Simulation simulation(corridor());
  EXPECT_THROW(simulation.resume(), InputError);
  ASSERT_EQ(simulation.advance_to(20), SimulationState::contact);
  const double t = simulation.time();
  // With the same motion, and with another one that approaches.
  EXPECT_EQ(simulation.resume(), SimulationState::contact);
  EXPECT_TRUE(simulation.contact_again());
  simulation.set_motion(0, linear(t, 9.5, 1, 0, 1));
  simulation.resume();
  EXPECT_EQ(simulation.advance_to(20), SimulationState::contact);
  EXPECT_TRUE(simulation.contact_again());
  EXPECT_NEAR(simulation.time(), t, 1e-12);
  EXPECT_EQ(simulation.contacts(), 1u);
  // Along the wall; where touching counts, that is a contact.
  simulation.set_motion(0, linear(t, 9.5, 0, 0, 0.25));
  simulation.resume();
  EXPECT_EQ(simulation.advance_to(20), SimulationState::finished);
  Simulation closed(corridor(), Touch::closed);
  closed.advance_to(20);
  closed.set_motion(0, linear(closed.time(), 9.5, 0, 0, 0.25));
  closed.resume();
  EXPECT_EQ(closed.advance_to(20), SimulationState::contact);
  EXPECT_TRUE(closed.contact_again());
}

TEST(ResumedSimulation, HandsOutContactsOfSeveralPairsTogether) {
  Scene scene = corridor();
  scene.bodies.push_back({"ball 2", scene.bodies[0].polygon, from_keyframes({{0, 2, 3, 0}, {100, 302, 3, 0}})});
  Simulation simulation(scene);
  ASSERT_EQ(simulation.advance_to(20), SimulationState::contact);
  ASSERT_EQ(simulation.also().size(), 1u);
  // One goes back, and the other one's contact is there still.
  simulation.set_motion(0, linear(simulation.time(), 9.5, -1));
  EXPECT_EQ(simulation.resume(), SimulationState::contact);
  EXPECT_TRUE(simulation.contact_again());
  EXPECT_EQ(*simulation.pair(), (std::array<BodyId, 2>{2, 3}));
  EXPECT_TRUE(simulation.also().empty());
  simulation.set_motion(3, linear(simulation.time(), 9.5, -2, 3));
  EXPECT_EQ(simulation.resume(), SimulationState::running);
  EXPECT_EQ(simulation.advance_to(20), SimulationState::contact);
  EXPECT_EQ(*simulation.pair(), (std::array<BodyId, 2>{1, 3}));
}

/// A ball that falls and loses half of its speed each time comes to rest after infinitely many contacts.
TEST(ResumedSimulation, EndsWhereContactsDoNot) {
  Scene scene;
  scene.end = 100;
  const auto fall = [](double t, double y, double v) {
    MotionPiece piece;
    piece.y = {y, v, -5};
    piece.origin = t;
    return Motion{{piece}};
  };
  scene.bodies = {{"ball", {{-0.5, 0}, {0, -0.5}, {0.5, 0}, {0, 0.5}}, fall(0, 3, 0)},
                  {"floor", {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}, {}}};
  SimulationOptions options;
  options.max_contacts_per_time = 20;
  Simulation simulation(scene, options);
  double bounces = 0, v = std::sqrt(50.0);
  for (; simulation.advance_to(100) == SimulationState::contact && bounces < 1000; ++bounces) {
    v /= 2;
    simulation.set_motion(0, fall(simulation.time(), 0.5 + 0x1p-46, v));
    simulation.resume();
  }
  EXPECT_EQ(simulation.state(), SimulationState::undecided);
  EXPECT_NE(simulation.reason().find("\"ball\" and \"floor\" came into contact more than 20 times"), std::string::npos)
      << simulation.reason();
  EXPECT_LT(bounces, 100);
  EXPECT_THROW(simulation.resume(), UndecidedError);
}

TEST(ResumedSimulation, BodiesComeAndGo) {
  SimulationOptions options;
  options.record = true;
  Simulation simulation(corridor(), options);
  simulation.advance_to(1);
  Body post{"post", {{7, -0.25}, {7.5, -0.25}, {7.5, 0.25}, {7, 0.25}}, {}};
  Body in_the_way = post;
  in_the_way.polygon = {{4, 0}, {6, 0}, {6, 1}};
  EXPECT_THROW(simulation.add_body(in_the_way), InputError);
  EXPECT_EQ(simulation.add_body(post), 3);
  ASSERT_EQ(simulation.advance_to(20), SimulationState::contact);
  EXPECT_NEAR(simulation.time(), 1.5, 1e-12);
  EXPECT_EQ(*simulation.pair(), (std::array<BodyId, 2>{0, 3}));
  simulation.remove_body(3);
  EXPECT_EQ(simulation.state(), SimulationState::contact);
  EXPECT_THROW(simulation.set_motion(3, {}), InputError);
  EXPECT_THROW(simulation.remove_body(3), InputError);
  simulation.resume();
  ASSERT_EQ(simulation.advance_to(20), SimulationState::contact);
  EXPECT_NEAR(simulation.time(), 2.5, 1e-12);
  simulation.ignore(0, 2);
  simulation.resume();
  EXPECT_EQ(simulation.advance_to(4), SimulationState::running);
  const std::vector<Scene> record = simulation.record();
  ASSERT_EQ(record.size(), 4u);
  EXPECT_EQ(record[1].bodies.size(), 4u);
  EXPECT_EQ(record[2].bodies.size(), 3u);
  for (const Scene& scene : record) EXPECT_EQ(check(scene).outcome, Outcome::free);
}

/// A hand comes to a part, takes it along, and puts it down.
TEST(ResumedSimulation, APartIsTakenAlong) {
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Scene scene;
  scene.end = 20;
  scene.bodies = {{"hand", square, from_velocity({1, 0})},
                  {"part", square, from_keyframes({{0, 5, 0, 0}})},
                  {"wall", square, from_keyframes({{0, 5, 5, 0}})}};
  Simulation simulation(scene);
  ASSERT_EQ(simulation.advance_to(20), SimulationState::contact);
  EXPECT_NEAR(simulation.time(), 4, 1e-12);
  simulation.set_motion(0, linear(simulation.time(), 4, 0, 0, 1));
  EXPECT_THROW(simulation.set_parent(1, 0, linear(0, 2, 0)), InputError);
  simulation.set_parent(1, 0, linear(0, 1, 0));
  EXPECT_EQ(simulation.scene().bodies[1].relative_to, "hand");
  EXPECT_THROW(simulation.remove_body(0), InputError);
  simulation.resume();
  ASSERT_EQ(simulation.advance_to(20), SimulationState::contact);
  EXPECT_EQ(*simulation.pair(), (std::array<BodyId, 2>{1, 2}));
  EXPECT_NEAR(simulation.time(), 8, 1e-12);
  simulation.set_parent(1, std::nullopt, linear(0, 5, 0, 4));
  simulation.set_motion(0, linear(simulation.time(), 4, -1, 4));
  simulation.resume();
  EXPECT_EQ(simulation.advance_to(20), SimulationState::finished);
}

TEST(ResumedSimulation, BoundsTheRelativeVelocity) {
  Scene scene = corridor();
  const double w = 2 * std::atan(1.0);
  scene.bodies[0].motion = Motion{{{{2, 3}, {0, 0.5}, AngleRotation{{0, w}}}}};
  scene.bodies[2].motion = from_velocity({-0.25, 0}, 0);
  scene.bodies[0].polygon = {{-0.5, 0}, {0, -0.25}, {0.5, 0}, {0, 0.5}};
  Simulation simulation(scene);
  ASSERT_EQ(simulation.advance_to(20), SimulationState::contact);
  const Contact& contact = *simulation.contact();
  const ContactMotion motion = simulation.relative_velocity(contact);
  const BodyPose pose = poses_at(scene, simulation.time())[0];
  const double rx = contact.point.x - pose.origin.x, ry = contact.point.y - pose.origin.y;
  const double vx = 3 - w * ry + 0.25, vy = 0.5 + w * rx;
  const auto holds = [](const Enclosure& e, double x) {
    EXPECT_LE(e.lo, e.hi);
    EXPECT_LT(e.hi - e.lo, 1e-12);
    EXPECT_NEAR(e.lo, x, 1e-12);
  };
  const double sign = contact.vertex.body == 0 ? 1 : -1;
  holds(motion.velocity[0], sign * vx);
  holds(motion.velocity[1], sign * vy);
  holds(motion.normal[0], contact.normal.x);
  holds(motion.normal[1], contact.normal.y);
  holds(motion.along_normal, sign * (vx * contact.normal.x + vy * contact.normal.y));
  EXPECT_LT(motion.along_normal.hi, 0);
}

}  // namespace
}  // namespace taut::testing
