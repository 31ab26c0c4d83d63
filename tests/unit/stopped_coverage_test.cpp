// Answers of searches that are stopped at once still count the pairs of their scene.
#include <gtest/gtest.h>

#include <atomic>
#include <sstream>

#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/envelope.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/motions.hpp"
#include "taut/path.hpp"
#include "taut/proof.hpp"
#include "taut/separate.hpp"
#include "taut/simulation.hpp"
#include "taut/static_map.hpp"

namespace taut {
namespace {

const std::atomic<bool> stopped{true};

Limits at_once() {
  Limits limits;
  limits.stop = &stopped;
  return limits;
}

Body square(const std::string& name, double x, double speed) {
  Body body;
  body.name = name;
  body.polygon = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
  if (speed != 0) body.motion = from_velocity({speed, 0});
  return body;
}

/// Four bodies that meet, thus six pairs, of which two are ignored.
Scene four_squares() {
  Scene scene;
  scene.end = 1;
  scene.bodies = {square("a", 0, 0), square("b", 1.5, -1), square("c", 3, -2), square("d", 5, -4.5)};
  scene.ignore = {{"a", "d"}, {"d", "a"}, {"b", "c"}};
  return scene;
}

void expect_none_reached(const Coverage& c, const char* question) {
  SCOPED_TRACE(question);
  EXPECT_EQ(c.pairs, 6u);
  EXPECT_EQ(c.ignored, 2u);
  EXPECT_EQ(c.not_reached, 4u);
  EXPECT_EQ(c.untested(), 6u);
  EXPECT_EQ(c.tested + c.apart + c.moving_alike + c.at_rest, 0u);
  EXPECT_FALSE(c.is_empty());
}

TEST(StoppedCoverage, OfEveryQuestion) {
  const Scene scene = four_squares();
  CheckOptions options;
  options.limits = at_once();
  std::ostringstream log;
  expect_none_reached(check(scene, options).coverage, "check");
  expect_none_reached(check_clearance(scene, 0.1, options).coverage, "check --clearance");
  expect_none_reached(intervals(scene, options).coverage, "intervals");
  expect_none_reached(range(scene, 0, options).coverage, "range");
  expect_none_reached(prove(scene, log, options).coverage, "prove");
  expect_none_reached(prove_clearance(scene, 0.1, log, options).coverage, "prove --clearance");
  ClearanceOptions nearest;
  nearest.limits = at_once();
  expect_none_reached(clearance(scene, nearest).coverage, "clearance");
  ProfileOptions profile;
  profile.limits = at_once();
  expect_none_reached(distance_profile(scene, profile).coverage, "clearance --profile");
  SeparateOptions directions;
  directions.limits = at_once();
  expect_none_reached(separate(scene, directions).coverage, "separate");
  EnvelopeOptions combinations;
  combinations.limits = at_once();
  Linkage linkage{{{"slide", 0, 1}}, scene, {}};
  for (Body& body : linkage.scene.bodies) body.motion = {};
  linkage.motions = {std::nullopt, JointMotion{Slide{{1, 0}}, 0}};
  expect_none_reached(envelope(linkage, combinations).coverage, "envelope");
  PathOptions ways;
  ways.limits = at_once();
  PathProblem problem;
  problem.linkage = linkage;
  problem.goal[0] = {1, 1};
  expect_none_reached(find_path(problem, ways).coverage, "path");
}

TEST(StoppedCoverage, OfASimulation) {
  SimulationOptions options;
  options.limits = at_once();
  const Simulation simulation(four_squares(), options);
  EXPECT_EQ(simulation.state(), SimulationState::undecided);
  expect_none_reached(simulation.coverage(), "simulation");
}

TEST(StoppedCoverage, OfAMap) {
  const StaticMap map({square("a", 0, 0), square("b", 3, 0)});
  CheckOptions options;
  options.limits = at_once();
  const Body mover = square("mover", 1.5, 1);
  const Answer answer = map.check(map.prepare(mover), mover.motion, 0, 1, options);
  EXPECT_EQ(answer.outcome, Outcome::undecided);
  EXPECT_EQ(answer.coverage.pairs, 2u);
  EXPECT_EQ(answer.coverage.not_reached, 2u);
  EXPECT_EQ(answer.coverage.tested + answer.coverage.apart, 0u);
}

/// What is stopped at once is not thereby accepted.
TEST(StoppedCoverage, IgnoredBodiesMustExist) {
  Scene scene = four_squares();
  scene.ignore.push_back({"a", "nobody"});
  CheckOptions options;
  options.limits = at_once();
  EXPECT_THROW(check(scene, options), InputError);
  EXPECT_THROW(check_clearance(scene, 0.1, options), InputError);
}

}  // namespace
}  // namespace taut
