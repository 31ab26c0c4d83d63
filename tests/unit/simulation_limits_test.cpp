// A simulation under the limits that check() knows.
#include <gtest/gtest.h>

#include <atomic>

#include "generators/generators.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"

namespace taut {
namespace {

const Scene& meshing_gears() {
  static const Scene scene = gen::make_gears({});
  return scene;
}

/// What is still told, and what is not.
void expect_undecided(Simulation& simulation, const std::string& reason) {
  EXPECT_EQ(simulation.state(), SimulationState::undecided);
  EXPECT_NE(simulation.reason().find(reason), std::string::npos) << simulation.reason();
  const double time = simulation.time();
  const std::uint64_t events = simulation.events();
  EXPECT_GE(time, meshing_gears().start);
  EXPECT_LT(time, meshing_gears().end);
  EXPECT_FALSE(simulation.contact());
  EXPECT_FALSE(simulation.next_event());
  EXPECT_FALSE(simulation.step());
  EXPECT_EQ(simulation.advance_to(meshing_gears().end), SimulationState::undecided);
  EXPECT_EQ(simulation.time(), time);
  EXPECT_EQ(simulation.events(), events);
  EXPECT_THROW(simulation.tiling(), UndecidedError);
  EXPECT_THROW(simulation.active_set(), UndecidedError);
  EXPECT_THROW(simulation.set_motion(0, {}), UndecidedError);
}

TEST(SimulationLimits, StopsAfterSoManyEventsAsCheckDoes) {
  SimulationOptions options;
  options.max_events = 5;
  Simulation simulation(meshing_gears(), options);
  EXPECT_EQ(simulation.reason(), "");
  EXPECT_EQ(simulation.advance_to(meshing_gears().end), SimulationState::undecided);
  EXPECT_EQ(simulation.events(), 5u);
  expect_undecided(simulation, "the limit of 5 events was reached");
  CheckOptions same;
  same.max_events = 5;
  const Answer answer = check(meshing_gears(), same);
  EXPECT_EQ(simulation.time(), answer.free_until);
  EXPECT_EQ(simulation.reason(), answer.reason);
}

TEST(SimulationLimits, EnoughEventsChangeNothing) {
  SimulationOptions options;
  options.max_events = 1000000;
  options.limits.max_seconds = 1000;
  std::atomic<bool> stop{false};
  options.limits.stop = &stop;
  Simulation simulation(meshing_gears(), options);
  EXPECT_EQ(simulation.advance_to(meshing_gears().end), SimulationState::finished);
  CheckOptions kinetic;
  kinetic.engine = EngineChoice::kinetic;
  EXPECT_EQ(simulation.events(), check(meshing_gears(), kinetic).events);
}

TEST(SimulationLimits, StopsWhenTold) {
  std::atomic<bool> stop{false};
  SimulationOptions options;
  options.limits.stop = &stop;
  Simulation simulation(meshing_gears(), options);
  ASSERT_TRUE(simulation.step());
  stop = true;
  EXPECT_FALSE(simulation.step());
  expect_undecided(simulation, "interrupted");
}

/// Not even the tiling at the start may be there.
TEST(SimulationLimits, StopsWhileItIsMade) {
  std::atomic<bool> stop{true};
  SimulationOptions options;
  options.limits.stop = &stop;
  Simulation decided(meshing_gears(), options);
  expect_undecided(decided, "interrupted");
  EXPECT_EQ(decided.time(), meshing_gears().start);
  options.limits.stop = nullptr;
  options.limits.max_seconds = 0;
  Simulation late(meshing_gears(), options);
  expect_undecided(late, "the time limit was reached");
  EXPECT_EQ(late.certificates(), 0u);
}

/// A contact that was found stays the answer.
TEST(SimulationLimits, DoNotTakeBackAContact) {
  gen::GearOptions hit;
  hit.hit = true;
  const Scene scene = gen::make_gears(hit);
  std::atomic<bool> stop{false};
  SimulationOptions options;
  options.limits.stop = &stop;
  Simulation simulation(scene, options);
  ASSERT_EQ(simulation.advance_to(scene.end), SimulationState::contact);
  stop = true;
  EXPECT_EQ(simulation.advance_to(scene.end), SimulationState::contact);
  EXPECT_FALSE(simulation.step());
  EXPECT_EQ(simulation.state(), SimulationState::contact);
}

TEST(SimulationLimits, RefusedInputIsNoMatterOfLimits) {
  Scene scene = meshing_gears();
  scene.bodies[1].polygon.resize(2);
  EXPECT_THROW(Simulation{scene}, InputError);
}

TEST(SimulationLimits, EndAWorldWithWhatIsProved) {
  Scene scene = gen::make_planetary({});
  SimulationOptions options;
  options.limits.max_seconds = 0;
  Simulation at_once(scene, options);
  EXPECT_EQ(at_once.state(), SimulationState::undecided);
  EXPECT_EQ(at_once.reason(), "the time limit was reached");
  EXPECT_EQ(at_once.time(), scene.start);
  EXPECT_FALSE(at_once.next_event());
  EXPECT_THROW(at_once.set_motion(0, {}), UndecidedError);
  std::atomic<bool> stop{false};
  options = {};
  options.limits.stop = &stop;
  Simulation stopped(scene, options);
  EXPECT_EQ(stopped.advance_to(0.25), SimulationState::running);
  stop = true;
  EXPECT_EQ(stopped.advance_to(scene.end), SimulationState::undecided);
  EXPECT_EQ(stopped.reason(), "interrupted");
  EXPECT_GE(stopped.time(), 0.25);
  EXPECT_LT(stopped.time(), scene.end);
  options = {};
  options.max_events = 100;
  Simulation counted(scene, options);
  EXPECT_EQ(counted.advance_to(scene.end), SimulationState::undecided);
  EXPECT_LE(counted.events(), 100u);
  EXPECT_LT(counted.time(), scene.end);
}

}  // namespace
}  // namespace taut
