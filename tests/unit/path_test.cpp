// Ways, and that there are none: closed forms, limits, errors.
#include "taut/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/made_path.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

using testing::expect_proved;
using testing::freely;

Polygon rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Body walls(std::vector<Polygon> outlines) {
  Body body{"walls", {}, {}};
  for (Polygon& outline : outlines) body.parts.push_back({std::move(outline), {}});
  return body;
}

/// A room of 8 by 4 with a wall in the middle, which has a slot from y = 1 to `top`.
PathProblem slot(double top, bool turns = false) {
  PathProblem problem;
  problem.linkage.joints = {{"x", 0, 8}, {"y", 0, 4}};
  if (turns) problem.linkage.joints.push_back({"turn", 0, 360});
  problem.linkage.scene.bodies = {{"mover", rectangle(-0.5, -0.5, 0.5, 0.5), {}},
                                  walls({rectangle(-1, -1, 9, 0), rectangle(-1, 4, 9, 5), rectangle(-1, 0, 0, 4),
                                         rectangle(8, 0, 9, 4), rectangle(3, 0, 5, 1), rectangle(3, top, 5, 4)})};
  problem.linkage.motions = {freely(0, 1, turns ? std::optional(2) : std::nullopt), std::nullopt};
  problem.periodic[2] = turns;
  problem.start = {1.5, 2, 30};
  problem.goal[0] = {6.5, 6.5};
  problem.goal[1] = {2, 2};
  return problem;
}

/// A rod of half length h in two corridors of width 1 that meet at a right angle.
PathProblem corner(double half) {
  PathProblem problem;
  problem.linkage.joints = {{"x", 0, 5}, {"y", 0, 5}, {"turn", 0, 360}};
  problem.linkage.scene.bodies = {{"rod", rectangle(-half, -0.01, half, 0.01), {}},
                                  walls({rectangle(-1, -1, 0, 6), rectangle(0, -1, 6, 0), rectangle(1, 1, 6, 6),
                                         rectangle(0, 5, 1, 6), rectangle(5, 0, 6, 1)})};
  problem.linkage.motions = {freely(0, 1, 2), std::nullopt};
  problem.periodic[2] = true;
  problem.start = {0.5, 3.4, 90};
  for (std::size_t k = 0; k < 3; ++k)
    problem.goal[k] = std::array<double, 2>{JointValues{3.4, 0.5, 180}[k], JointValues{3.4, 0.5, 180}[k]};
  return problem;
}

TEST(Path, TranslationsAreExact) {
  for (const Touch touch : {Touch::open, Touch::closed}) {
    PathOptions options;
    options.touch = touch;
    options.tolerance = 1;  // means nothing here
    const auto asked = [&](double top) { return find_path(slot(top), options); };
    const PathAnswer exact = asked(2);
    EXPECT_TRUE(exact.exact);
    EXPECT_EQ(exact.outcome, touch == Touch::open ? PathOutcome::path : PathOutcome::none);
    if (touch == Touch::open) expect_proved(slot(2), exact, options);
    expect_proved(slot(2 + 0x1p-40), asked(2 + 0x1p-40), options);
    EXPECT_NE(asked(std::nextafter(2, 3)).outcome, PathOutcome::none);
    EXPECT_EQ(asked(std::nextafter(2, 1)).outcome, PathOutcome::none);
    expect_proved(slot(2.25), asked(2.25), options);
  }
}

/// Joints in another order, a joint that goes the other way, a frame that is moved: still translations.
TEST(Path, TranslationsOfOtherForms) {
  PathProblem problem = slot(2);
  PathProblem other = problem;
  other.linkage.joints = {{"up", 0, 8}, {"back", -8, 0}, {"idle", 0, 1}};
  other.linkage.scene.bodies.push_back({"carriage", rectangle(20, 20, 21, 21), {}});
  other.linkage.scene.bodies[0].relative_to = "carriage";
  other.linkage.scene.ignore = {{"carriage", "*"}};
  other.linkage.motions = {JointMotion{Slide{{0, 1}}, 0, 0.5, 0}, std::nullopt, JointMotion{Slide{{-1, 0}}, 1, 1, 0}};
  other.start = {4, -1.5, 0.25};
  other.goal = {};
  other.goal[0] = {4, 4};
  other.goal[1] = {-6.5, -6.5};
  for (const Touch touch : {Touch::open, Touch::closed}) {
    PathOptions options;
    options.touch = touch;
    const PathAnswer answer = find_path(other, options);
    EXPECT_TRUE(answer.exact);
    EXPECT_EQ(answer.outcome, find_path(problem, options).outcome);
    if (answer.outcome == PathOutcome::path) expect_proved(other, answer, options);
  }
}

/// A hook that a carriage carries along x. The goal "outside" is about the carriage's box as well, which only follows
/// one of the two joints.
TEST(Path, TranslationsOutOfBoxesThatMoveInDifferentWays) {
  PathProblem problem;
  problem.linkage.scene.bodies = {{"carriage", rectangle(0, 5, 1, 6), {}},
                                  {"hook", rectangle(0.25, 3, 0.75, 4), {}},
                                  walls({rectangle(0, 0, 10, 1), rectangle(9, 7, 10, 8)})};
  problem.linkage.scene.bodies[1].relative_to = "carriage";
  problem.linkage.scene.ignore = {{"carriage", "*"}};
  problem.linkage.motions = {JointMotion{Slide{{-2, 0}}, 0, 1, 0}, JointMotion{Slide{{0, 1}}, 1, 1, 0}, std::nullopt};
  problem.start = {-2, 0};
  problem.goal_outside = true;
  for (const double least : {0.5, 0.4375}) {
    problem.linkage.joints = {{"away", -4.75, least}, {"up", -2, 0.5}};
    const PathAnswer answer = find_path(problem);
    EXPECT_TRUE(answer.exact);
    ASSERT_EQ(answer.outcome, least == 0.5 ? PathOutcome::path : PathOutcome::none);
    if (answer.outcome == PathOutcome::path) {
      expect_proved(problem, answer);
      EXPECT_EQ(answer.waypoints.back()[0], 0.5);
    }
  }
  // Turned by another joint, the mover is not one of translations.
  problem.linkage.joints = {{"away", -4.75, 0.4375}, {"up", -2, 0.5}, {"turn", 0, 360}};
  problem.periodic[2] = true;
  problem.linkage.motions[2] = JointMotion{Revolute{{5, 0.5}}, 2, 1, 0};
  PathOptions coarse;
  coarse.tolerance = 0.1;
  EXPECT_FALSE(find_path(problem, coarse).exact);
}

/// Between rails that lean, as wide as the mover: it slides along them, and to the end of the goal's range.
TEST(Path, TranslationsAlongALeaningSlot) {
  PathProblem problem;
  const auto leaning = [](double a0, double b0, double a1, double b1) {
    const auto at = [](double a, double b) { return Point{3 * a - b, 4 * a + 2 * b}; };
    return Polygon{at(a0, b0), at(a1, b0), at(a1, b1), at(a0, b1)};
  };
  problem.linkage.joints = {{"along", 0, 10}};
  problem.linkage.scene.bodies = {{"mover", leaning(0, 0, 1, 1), {}},
                                  walls({leaning(-1, -1, 12, 0), leaning(-1, 1, 12, 2), leaning(7, 0, 12, 1)})};
  problem.linkage.motions = {JointMotion{Slide{{3, 4}}, 0, 1, 0}, std::nullopt};
  problem.goal[0] = {6, 9};
  PathOptions options;
  const PathAnswer open = find_path(problem, options);
  EXPECT_TRUE(open.exact);
  expect_proved(problem, open, options);
  EXPECT_EQ(open.waypoints.back()[0], 6);
  problem.goal[0] = {std::nextafter(6, 7), 9};
  const PathAnswer none = find_path(problem, options);
  EXPECT_TRUE(none.exact);
  EXPECT_EQ(none.outcome, PathOutcome::none);
}

TEST(Path, OfARodAroundACorner) {
  const double critical = std::sqrt(2) - 0.02;  // half of it
  for (const double share : {0.9, 0.99, 0.999})
    expect_proved(corner(share * critical), find_path(corner(share * critical)));
  for (const double share : {1.001, 1.01, 1.1}) {
    const PathAnswer none = find_path(corner(share * critical));
    EXPECT_EQ(none.outcome, PathOutcome::none) << none.reason;
    EXPECT_FALSE(none.exact);
  }
}

TEST(Path, TurnsThroughADoor) {
  for (const double top : {2.001, 2.1}) expect_proved(slot(top, true), find_path(slot(top, true)));
  EXPECT_EQ(find_path(slot(1.999, true)).outcome, PathOutcome::none);
  // As wide as the square: with turns this stays open, and says where.
  PathOptions coarse;
  coarse.tolerance = 0.01;
  const PathAnswer tight = find_path(slot(2, true), coarse);
  EXPECT_EQ(tight.outcome, PathOutcome::undecided);
  ASSERT_TRUE(tight.tight);
  EXPECT_EQ(tight.tight->pair, (std::array<BodyId, 2>{0, 1}));
  EXPECT_GE(tight.tight->values[0], 2);
  EXPECT_LE(tight.tight->values[0], 6);
  EXPECT_FALSE(tight.reason.empty());
  // A corner of the square is at the slot's floor or ceiling, and so is one on the other side.
  ASSERT_EQ(tight.tight->features.size(), 2U);
  std::set<int> sides;
  for (const TightFeatures& f : tight.tight->features) {
    EXPECT_LT(f.distance, 0.05);
    EXPECT_NE(f.vertex.body, f.edge.body);
    const int part = f.vertex.body == 1 ? f.vertex.part : f.edge.part;
    EXPECT_TRUE(part == 4 || part == 5) << part;
    sides.insert(part);
  }
  EXPECT_EQ(sides.size(), 2U);
}

TEST(Path, KeepsAClearance) {
  PathOptions options;
  options.clearance = 0.1;
  expect_proved(slot(2.21, true), find_path(slot(2.21, true), options), options);
  EXPECT_EQ(find_path(slot(2.19, true), options).outcome, PathOutcome::none);
  expect_proved(slot(2.21), find_path(slot(2.21), options), options);
  options.clearance = 2;
  EXPECT_THROW(find_path(slot(2.21), options), InputError);
}

TEST(Path, GoalsThatAreRangesOrOutside) {
  PathProblem problem = slot(2.25, true);
  problem.goal[0] = {6, 7};
  problem.goal[1].reset();
  expect_proved(problem, find_path(problem));
  // A goal all of whose combinations collide is none; a single one is an error.
  problem.goal[0] = {3.5, 4.5};
  problem.goal[1] = {0.25, 0.5};
  EXPECT_EQ(find_path(problem).outcome, PathOutcome::none);
  problem.goal[0] = {4, 4};
  problem.goal[1] = {0.25, 0.25};
  problem.goal[2] = {0, 0};
  EXPECT_THROW(find_path(problem), InputError);
  // Out of a cup.
  PathProblem cup;
  cup.linkage.joints = {{"x", -5, 5}, {"y", -5, 5}, {"turn", -180, 180}};
  cup.linkage.scene.bodies = {
      {"spoon", rectangle(-0.2, -0.9, 0.2, 0.9), {}},
      {"cup", {{-1, -1}, {1, -1}, {1, 1}, {0.8, 1}, {0.8, -0.95}, {-0.8, -0.95}, {-0.8, 1}, {-1, 1}}, {}}};
  cup.linkage.motions = {freely(0, 1, 2), std::nullopt};
  cup.goal_outside = true;
  expect_proved(cup, find_path(cup));
  cup.linkage.scene.bodies[1].polygon = {};
  cup.linkage.scene.bodies[1].parts = {{rectangle(-1, -1, 1, 1), {rectangle(-0.8, -0.95, 0.8, 0.95)}}};
  EXPECT_EQ(find_path(cup).outcome, PathOutcome::none);
}

TEST(Path, StartsAndGoalsThatCollide) {
  const auto message = [](const PathProblem& problem, Touch touch) -> std::string {
    PathOptions options;
    options.touch = touch;
    try {
      find_path(problem, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  PathProblem problem = slot(2.25);
  problem.start = {0.5, 2};
  EXPECT_EQ(message(problem, Touch::open), "");
  EXPECT_NE(message(problem, Touch::closed).find("start: \"mover\" and \"walls\" collide or touch"), std::string::npos);
  problem.start = {0.25, 2};
  EXPECT_NE(message(problem, Touch::open).find("start: \"mover\" and \"walls\" collide"), std::string::npos);
  // A place nearby: 1/4 farther there is room, and the steps to it double.
  const std::string near = message(problem, Touch::open);
  const std::size_t place = near.find("none do at x = ");
  ASSERT_NE(place, std::string::npos) << near;
  const double x = std::stod(near.substr(place + 15));
  EXPECT_GT(x, 0.5);
  EXPECT_LE(x, 0.75 + 0x1p-10);
  EXPECT_NE(near.find("y = 2", place), std::string::npos);
  // Nothing is free near the middle of a thick wall.
  problem.start = {4, 3};
  EXPECT_EQ(message(problem, Touch::open).find("none do at"), std::string::npos);
  problem.start = {9, 2};
  EXPECT_NE(message(problem, Touch::open).find("start.x: 9 is not within the joint's range, [0, 8]"),
            std::string::npos);
}

/// The picture shows what the answer says: cells, start, goal, and a way that leaves one side and comes in at the
/// other.
TEST(Path, MapsOfTwoJoints) {
  const PathProblem reach = read_path_problem("examples/paths/reach.json");
  const std::string none = path_svg(reach, find_path(reach));
  // What is reached ends where cells collide: it gets to no place at which the shoulder is beyond them.
  const std::size_t begin = none.find("class=\"reached\""), end = none.find("fill", begin);
  ASSERT_NE(begin, std::string::npos);
  const std::string reached = none.substr(begin, end - begin);
  EXPECT_NE(reached.find("M90,"), std::string::npos) << reached;
  EXPECT_EQ(reached.find("H696V"), std::string::npos) << reached;
  for (const char* part : {"Way: none", "class=\"colliding\"", "class=\"start\"", "class=\"goal\"", ">shoulder (deg)<"})
    EXPECT_NE(none.find(part), std::string::npos) << part;
  EXPECT_EQ(none.find("class=\"way\""), std::string::npos);
  PathProblem around = slot(2.25);
  around.linkage.motions[0] = freely(std::nullopt, 1, 0);
  around.linkage.joints[0] = {"turn", 0, 360};
  around.linkage.scene.bodies[0].polygon = rectangle(1.5, 1.5, 2.5, 2.5);
  around.linkage.motions[0]->kind = FreeMotion{std::nullopt, 1, 0, {2, 2}};
  around.periodic[0] = true;
  around.start = {10, 0};
  around.goal = {};
  around.goal[0] = {350, 350};
  around.linkage.joints[1] = {"y", -1, 1};
  const PathAnswer answer = find_path(around);
  ASSERT_EQ(answer.outcome, PathOutcome::path);
  const std::string way = path_svg(around, answer);
  EXPECT_NE(way.find("class=\"way\""), std::string::npos);
  EXPECT_NE(way.find("clip-path=\"url(#frame)\""), std::string::npos);
  EXPECT_THROW(path_svg(slot(2.25, true), {}), InputError);
}

TEST(Path, ProblemsThatMakeNoSense) {
  PathProblem problem = slot(2.25, true);
  problem.periodic[0] = true;
  EXPECT_THROW(validate(problem), InputError);
  problem = slot(2.25, true);
  problem.linkage.joints[2].hi = 350;
  EXPECT_THROW(validate(problem), InputError);
  problem = slot(2.25, true);
  problem.goal = {};
  EXPECT_THROW(validate(problem), InputError);
  problem.goal[0] = {9, 10};
  EXPECT_THROW(validate(problem), InputError);
  problem = slot(2.25, true);
  problem.linkage.motions[0] = freely({}, {}, {});
  EXPECT_THROW(validate(problem), InputError);
  for (const double tolerance : {0.0, 2.0, std::nan("")}) {
    PathOptions options;
    options.tolerance = tolerance;
    EXPECT_THROW(find_path(slot(2.25), options), InputError);
  }
}

TEST(Path, LimitsAreKept) {
  PathOptions options;
  options.max_cells = 20;
  const PathAnswer few = find_path(corner(1.5), options);
  EXPECT_EQ(few.outcome, PathOutcome::undecided);
  EXPECT_NE(few.reason.find("cells"), std::string::npos);
  EXPECT_LE(few.cells.size(), 30U);
  options = {};
  options.limits.max_seconds = 0;
  EXPECT_EQ(find_path(corner(1.5), options).outcome, PathOutcome::undecided);
  PathProblem ignored = corner(1.2);
  ignored.linkage.scene.ignore = {{"rod", "walls"}};
  EXPECT_EQ(find_path(ignored).outcome, PathOutcome::untested);
}

/// A way over the ends of a joint with a period goes on beyond its range.
TEST(Path, UnwrapsPeriods) {
  PathProblem problem;
  problem.linkage.joints = {{"turn", 0, 360}};
  problem.linkage.scene.bodies = {{"hand", rectangle(0, -0.1, 2, 0.1), {}},
                                  {"post", rectangle(-1.5, -0.2, -1, 0.2), {}}};
  problem.linkage.motions = {JointMotion{Revolute{{0, 0}}, 0}, std::nullopt};
  problem.start = {20};
  problem.goal[0] = {340, 340};
  // Between 20 and 340 is the post, at 180.
  EXPECT_EQ(find_path(problem).outcome, PathOutcome::none);
  problem.periodic[0] = true;
  const PathAnswer answer = find_path(problem);
  expect_proved(problem, answer);
  EXPECT_NEAR(answer.waypoints.back()[0], -20, 1e-9);
}

TEST(Path, IsReadFromText) {
  const PathProblem problem = parse_path_problem(R"({"format": "taut-scene/1",
      "joints": {"x": [0, 10], "y": [0, 8], "turn": [0, 360]}, "periodic": ["turn"],
      "bodies": [{"name": "sofa", "polygon": [[0,0],[1,0],[0,1]],
                  "motion": {"free": {"x": "x", "y": "y", "deg": "turn", "pivot": [1, 0.5]}}},
                 {"name": "walls", "polygon": [[5,5],[6,5],[5,6]]}],
      "start": {"x": 1, "turn": 30, "y": 2}, "goal": {"x": [8, 9], "y": 7}})");
  EXPECT_EQ(problem.start, (JointValues{1, 2, 30, 0}));
  EXPECT_EQ(problem.periodic, (std::array<bool, max_joints>{false, false, true, false}));
  EXPECT_EQ(problem.goal[0], (std::array<double, 2>{8, 9}));
  EXPECT_EQ(problem.goal[1], (std::array<double, 2>{7, 7}));
  EXPECT_FALSE(problem.goal[2]);
  const auto& motion = std::get<FreeMotion>(problem.linkage.motions[0]->kind);
  EXPECT_EQ(*motion.deg, 2);
  EXPECT_EQ(motion.pivot.x, 1);
  const auto refusal = [](const std::string& rest) -> std::string {
    try {
      parse_path_problem(R"({"format": "taut-scene/1", "joints": {"x": [0, 10]}, "bodies": [
          {"name": "a", "polygon": [[0,0],[1,0],[0,1]], "motion": {"free": {"x": "x"}}}], )" +
                         rest + "}");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(R"("start": {"x": 1}, "goal": "outside")"), "");
  EXPECT_NE(refusal(R"("start": {"y": 1}, "goal": "outside")").find("start"), std::string::npos);
  EXPECT_NE(refusal(R"("start": {}, "goal": "outside")").find("does not name the joint \"x\""), std::string::npos);
  EXPECT_NE(refusal(R"("start": {"x": 1}, "goal": "inside")").find("goal"), std::string::npos);
  EXPECT_NE(refusal(R"("start": {"x": 1}, "goal": {"x": [2, 1]})").find("goal.x"), std::string::npos);
  EXPECT_NE(refusal(R"("start": {"x": 1}, "goal": {"x": 1}, "periodic": ["y"])").find("periodic"), std::string::npos);
  EXPECT_NE(refusal(R"("start": {"x": 1})").find(R"(write a scene as)"), std::string::npos);
  EXPECT_NE(refusal(R"("start": {"x": 11}, "goal": "outside")").find("11 is not within the joint's range, [0, 10]"),
            std::string::npos);
  const std::string far = refusal(R"("start": {"x": 1}, "goal": {"x": 12})");
  EXPECT_NE(far.find(": goal.x: 12 is not within"), std::string::npos) << far;
  EXPECT_NE(far.find("2:"), std::string::npos) << far;  // the line
  EXPECT_NE(refusal(R"("start": {"x": 1}, "goal": {"x": [12, 13.5]})").find("no value of [12, 13.5] is within"),
            std::string::npos);
}

/// Nothing moves on a way of no length. What rests was no part of the question, so it is no part of the scene's.
TEST(Path, AWayOfNoLengthIsFree) {
  PathProblem problem = slot(2.25);
  problem.goal = {};
  problem.goal[0] = {1, 2};
  problem.linkage.scene.bodies.push_back({"shelf", rectangle(2, 3, 4, 4), {}});
  problem.linkage.motions.emplace_back();
  const PathAnswer answer = find_path(problem);
  ASSERT_EQ(answer.outcome, PathOutcome::path) << answer.reason;
  EXPECT_EQ(answer.waypoints, (std::vector<JointValues>(2, problem.start)));
  const Answer checked = check(path_scene(problem, answer.waypoints));
  EXPECT_EQ(checked.outcome, Outcome::free);
  EXPECT_EQ(checked.coverage.tested + checked.coverage.apart, 2U);
  EXPECT_EQ(checked.coverage.ignored, 1U);
  problem.linkage.scene.at_rest = AtRest::test;
  EXPECT_THROW(find_path(problem), InputError);
}

}  // namespace
}  // namespace taut
