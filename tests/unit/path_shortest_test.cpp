// Short ways: closed forms lie between the bounds, and bounds of problems that are the same agree.
#include <gtest/gtest.h>

#include <cmath>

#include "support/made_path.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/path.hpp"

namespace taut {
namespace {

using testing::expect_proved;
using testing::freely;

Polygon box_of(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

/// A unit square in a room with a wall, and in the wall a slot from y = 1 to `top`; all is `scale` times as large, and
/// y goes down if it is mirrored.
PathProblem short_slot(double top, double scale = 1, bool mirrored = false, bool turns = false) {
  const double up = mirrored ? -scale : scale;
  const auto outline = [&](double x0, double y0, double x1, double y1) {
    const double a = y0 * up, b = y1 * up;
    return box_of(x0 * scale, std::min(a, b), x1 * scale, std::max(a, b));
  };
  PathProblem problem;
  problem.linkage.joints = {{"x", 0, 8 * scale}, {"y", std::min(0.0, 4 * up), std::max(0.0, 4 * up)}};
  if (turns) problem.linkage.joints.push_back({"turn", -90, 90});
  Body walls{"walls", {}, {}};
  for (const Polygon& p : {outline(3, 0, 5, 1), outline(3, top, 5, 4)}) walls.parts.push_back({p, {}});
  problem.linkage.scene.bodies = {{"mover", outline(-0.5, -0.5, 0.5, 0.5), {}}, walls};
  problem.linkage.motions = {freely(0, 1, turns ? std::optional(2) : std::nullopt), std::nullopt};
  problem.start = {1.5 * scale, 2 * up, 0};
  problem.goal[0] = {6.5 * scale, 6.5 * scale};
  problem.goal[1] = {2 * up, 2 * up};
  if (turns) problem.goal[2] = {0, 0};
  return problem;
}

PathLength length_of(const PathProblem& problem, const PathOptions& options) {
  const PathAnswer answer = find_path(problem, options);
  expect_proved(problem, answer, options);
  EXPECT_TRUE(answer.length.has_value());
  EXPECT_LE(answer.length->shortest_at_least, answer.length->way);
  return *answer.length;
}

TEST(PathShortest, NoWayIsNeededWhereTheStartIsInTheGoal) {
  PathOptions options;
  options.shortest = true;
  for (const bool turns : {false, true}) {
    PathProblem problem = short_slot(2.25, 1, false, turns);
    problem.goal[0] = {1, 2};
    const PathLength length = length_of(problem, options);
    EXPECT_EQ(length.way, 0);
    EXPECT_EQ(length.shortest_at_least, 0);
  }
}

TEST(PathShortest, NoWaypointComesTwiceInARow) {
  PathOptions options;
  options.shortest = true;
  const auto way = find_path(short_slot(2.25, 1, false, true), options).waypoints;
  ASSERT_GT(way.size(), 2u);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_NE(way[i - 1], way[i]) << i;
}

TEST(PathShortest, TranslationsAreShortestUpToRounding) {
  for (const double top : {2.0, 2.25}) {
    for (const Touch touch : {Touch::open, Touch::closed}) {
      if (top == 2 && touch == Touch::closed) continue;
      PathOptions options;
      options.touch = touch;
      options.shortest = true;
      const PathLength length = length_of(short_slot(top), options);
      const double known = 3 + 2 * std::hypot(1, 2.5 - top);
      EXPECT_LE(length.shortest_at_least, known);
      EXPECT_GE(length.way, known);
      EXPECT_NEAR(length.way, length.shortest_at_least, 1e-9);
    }
  }
}

/// Around corners that are round: tangents, arcs, and the straight way through the slot.
TEST(PathShortest, ClosedFormIsBetweenTheBounds) {
  PathOptions options;
  options.shortest = true;
  options.clearance = 0.0625;
  const PathProblem problem = short_slot(2.25);
  const PathLength length = length_of(problem, options);
  const double away = std::hypot(1, 0.25), c = options.clearance;
  const double known = 3 + 2 * (std::sqrt(away * away - c * c) + c * (std::atan(0.25) + std::asin(c / away)));
  EXPECT_LE(length.shortest_at_least, known);
  EXPECT_GE(length.way, known);
  EXPECT_LE(length.way, (1 + options.within) * length.shortest_at_least);
  EXPECT_EQ(length.weights[0], 1);
  EXPECT_EQ(length.weights[1], 1);
}

TEST(PathShortest, TheSameProblemHasTheSameLength) {
  for (const bool turns : {false, true}) {
    PathOptions options;
    options.shortest = true;
    options.within = turns ? 0.5 : 0.05;
    options.clearance = 0.0625;
    const PathLength first = length_of(short_slot(2.5, 1, false, turns), options);
    for (const bool mirrored : {false, true}) {
      PathOptions larger = options;
      larger.clearance *= 3;
      const PathLength second = length_of(short_slot(2.5, 3, mirrored, turns), larger);
      EXPECT_LE(second.shortest_at_least, 3 * first.way);
      EXPECT_LE(3 * first.shortest_at_least, second.way);
    }
    if (turns) {
      EXPECT_GT(first.weights[2], 0);
      EXPECT_LE(first.shortest_at_least, 3 + 2 * std::hypot(1, 0.5));  // no turn is needed
    }
  }
}

/// A disc, nearly, among boxes. It may turn, which does not help: the shortest way without turns is known exactly.
PathProblem disc_among_boxes(testing::Rng& rng, bool turns) {
  PathProblem problem;
  problem.linkage.joints = {{"x", 0, 10}, {"y", 0, 10}};
  Polygon disc;
  for (int k = 0; k < 16; ++k) disc.push_back({std::cos(k * M_PI / 8) / 4, std::sin(k * M_PI / 8) / 4});
  Body boxes{"boxes", {}, {}};
  for (int k = 0; k < 8; ++k) {
    const double x = rng.real(1.5, 8), y = rng.real(0, 9);
    boxes.parts.push_back({box_of(x, y, x + rng.real(0.5, 1), y + rng.real(0.5, 3)), {}});
  }
  problem.linkage.scene.bodies = {{"disc", disc, {}}, boxes};
  problem.linkage.motions = {freely(0, 1, turns ? std::optional(2) : std::nullopt), std::nullopt};
  problem.start = {0.5, 5, 0};
  problem.goal[0] = {9.7, 9.7};
  problem.goal[1] = {5, 5};
  if (turns) {
    problem.linkage.joints.push_back({"turn", 0, 360});
    problem.periodic[2] = true;
  }
  return problem;
}

TEST(PathShortest, TurnsThatDoNotHelpDoNotMatter) {
  int decided = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    PathOptions options;
    options.shortest = true;
    testing::Rng rng(seed), same(seed);
    const PathProblem still = disc_among_boxes(rng, false), turning = disc_among_boxes(same, true);
    const PathAnswer known = find_path(still, options);
    if (known.outcome != PathOutcome::path) continue;
    options.max_cells = 100'000;
    const PathAnswer found = find_path(turning, options);
    ASSERT_EQ(found.outcome, PathOutcome::path) << found.reason;
    // As a turned disc is in some places a little thinner, a way may gain that much.
    EXPECT_LE(found.length->shortest_at_least, known.length->way);
    EXPECT_GE(found.length->way, known.length->way * 0.995);
    EXPECT_LE(found.length->way, known.length->way * 1.1);
    ++all;
    if (found.length->way <= 1.05 * found.length->shortest_at_least) ++decided;
  }
  EXPECT_GE(all, 3);
  EXPECT_GE(2 * decided, all);
}

/// The shorter way leads over the ends of the joint's range.
TEST(PathShortest, GoesOverTheEndsOfAPeriod) {
  PathProblem problem = short_slot(2.5, 1, false, true);
  problem.linkage.joints[2] = {"turn", 0, 360};
  problem.periodic[2] = true;
  problem.start = {1.5, 2, 350};
  problem.goal = {};
  problem.goal[0] = {1.5, 1.5};
  problem.goal[1] = {2, 2};
  problem.goal[2] = {10, 10};
  PathOptions options;
  options.shortest = true;
  const PathLength length = length_of(problem, options);
  const double known = 20 * M_PI / 180 * std::sqrt(0.5);
  EXPECT_GE(length.way, known);
  EXPECT_LE(length.shortest_at_least, known * (1 + 1e-12));
  EXPECT_LE(length.way, 1.05 * length.shortest_at_least);
}

TEST(PathShortest, LimitsLeaveAWayAndABound) {
  PathOptions options;
  options.shortest = true;
  options.within = 0;
  options.max_cells = 2000;
  options.clearance = 0.0625;
  const PathAnswer answer = find_path(short_slot(2.25), options);
  EXPECT_EQ(answer.outcome, PathOutcome::path);
  EXPECT_FALSE(answer.reason.empty());
  ASSERT_TRUE(answer.length.has_value());
  EXPECT_GT(answer.length->shortest_at_least, 4.5);
  options.within = -0.1;
  EXPECT_THROW(find_path(short_slot(2.25), options), InputError);
}

}  // namespace
}  // namespace taut
