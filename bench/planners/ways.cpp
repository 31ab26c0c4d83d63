#include "planners/ways.hpp"

#include <fmt/format.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "planners/state_tests.hpp"
#include "taut/check.hpp"
#include "taut/path.hpp"

namespace taut::bench {
namespace {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

constexpr double half_turn = 3.14159265358979323846;
/// Of the space's extent, between two states that OMPL tests.
constexpr double sampled_share = 0.001;

/// A convex body that may move in all three ways about (0, 0), among convex walls.
struct WayProblem {
  std::string name;
  ConvexPieces mover, walls;
  Point lo, hi;
  std::array<double, 3> start;   ///< x, y, degrees
  std::array<double, 2> goal_x;  ///< all places with an x in between
  bool goes = true;              ///< known by the width of the passage
};

Polygon box_between(double x, double y, double to_x, double to_y) {
  return {{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}};
}

/// A rectangle from one corridor of width 1 into the other, around the corner. It goes if it is shorter than
/// 2 sqrt(2) - 2 width.
WayProblem corner(double room, const std::string& name) {
  const double width = 0.1, length = (2 * std::sqrt(2.0) - 2 * width) * (1 - room);
  WayProblem problem;
  problem.name = name;
  problem.mover = {box_between(-length / 2, -width / 2, length / 2, width / 2)};
  problem.walls = {box_between(-1, -1, 0, 6), box_between(0, -1, 6, 0), box_between(1, 1, 6, 6),
                   box_between(0, 5, 1, 6), box_between(5, 0, 6, 1)};
  problem.lo = {0, 0};
  problem.hi = {5, 5};
  problem.start = {0.5, 3.4, 90};
  problem.goal_x = {3.4, 5};
  problem.goes = room > 0;
  return problem;
}

/// A rectangle through a door in a wall. It goes if the door is wider than its shorter side.
WayProblem door(double length, double width, double share, const std::string& name) {
  const double half = width * share / 2;
  WayProblem problem;
  problem.name = name;
  problem.mover = {box_between(-length / 2, -width / 2, length / 2, width / 2)};
  problem.walls = {box_between(-0.1, half, 0.1, 4), box_between(-0.1, -4, 0.1, -half)};
  problem.lo = {-3, -3};
  problem.hi = {3, 3};
  problem.start = {-2, 0.7, 35};
  problem.goal_x = {1.5, 3};
  problem.goes = share > 1;
  return problem;
}

/// A bar out of a trap, through a funnel that leads back inside.
WayProblem trap(double mouth, const std::string& name) {
  WayProblem problem;
  problem.name = name;
  problem.mover = {box_between(-0.25, -0.1, 0.25, 0.1)};
  const double m = mouth / 2;
  problem.walls = {box_between(-2, -1.6, -1.8, 1.6),
                   box_between(-2, 1.4, 1, 1.6),
                   box_between(-2, -1.6, 1, -1.4),
                   {{-0.2, m}, {-0.1, m}, {1, 1.5}, {0.9, 1.5}},
                   {{-0.2, -m}, {0.9, -1.5}, {1, -1.5}, {-0.1, -m}}};
  problem.lo = {-4, -4};
  problem.hi = {4, 4};
  problem.start = {-1.4, 0.9, 60};
  problem.goal_x = {2, 4};
  problem.goes = mouth > 0.2;
  return problem;
}

std::vector<WayProblem> way_problems() {
  return {corner(0.1, "corner, 10 %"),
          corner(0.01, "corner, 1 %"),
          corner(0.001, "corner, 0.1 %"),
          corner(-0.01, "corner, too long by 1 %"),
          door(0.6, 0.6, 1.05, "square, door 1.05"),
          door(0.6, 0.6, 1.01, "square, door 1.01"),
          door(0.6, 0.6, 0.99, "square, door 0.99"),
          door(1.6, 0.4, 1.1, "plank, door 1.1"),
          door(1.6, 0.4, 0.97, "plank, door 0.97"),
          trap(0.3, "trap, mouth 1.5"),
          trap(0.19, "trap, mouth 0.95")};
}

PathProblem path_problem(const WayProblem& of) {
  PathProblem problem;
  problem.linkage.joints = {{"x", of.lo.x, of.hi.x}, {"y", of.lo.y, of.hi.y}, {"turn", 0, 360}};
  problem.periodic[2] = true;
  Body mover{"mover", {}, {}}, walls{"walls", {}, {}};
  for (const Polygon& piece : of.mover) mover.parts.push_back({piece, {}});
  for (const Polygon& piece : of.walls) walls.parts.push_back({piece, {}});
  problem.linkage.scene.bodies = {mover, walls};
  problem.linkage.motions = {JointMotion{FreeMotion{0, 1, 2, {}}}, std::nullopt};
  for (std::size_t k = 0; k < 3; ++k) problem.start[k] = of.start[k];
  problem.goal[0] = of.goal_x;
  return problem;
}

class SampledPoses : public ob::StateValidityChecker {
 public:
  SampledPoses(const ob::SpaceInformationPtr& si, StateTest& test) : ob::StateValidityChecker(si), test_(test) {}
  bool isValid(const ob::State* state) const override {
    const auto* s = state->as<ob::SE2StateSpace::StateType>();
    return si_->satisfiesBounds(state) && test_.free({s->getX(), s->getY(), s->getYaw()});
  }

 private:
  StateTest& test_;
};

class GoalRange : public ob::GoalSampleableRegion {
 public:
  GoalRange(const ob::SpaceInformationPtr& si, const std::array<double, 2>& x)
      : ob::GoalSampleableRegion(si), x_(x), sampler_(si->allocStateSampler()) {}

  double distanceGoal(const ob::State* state) const override {
    const double x = state->as<ob::SE2StateSpace::StateType>()->getX();
    return std::max({0.0, x_[0] - x, x - x_[1]});
  }
  void sampleGoal(ob::State* state) const override {
    sampler_->sampleUniform(state);
    state->as<ob::SE2StateSpace::StateType>()->setX(rng_.uniformReal(x_[0], x_[1]));
  }
  unsigned maxSampleCount() const override { return UINT_MAX; }

 private:
  std::array<double, 2> x_;
  ob::StateSamplerPtr sampler_;
  mutable ::ompl::RNG rng_;
};

double processor_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

using MakePlanner = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr&)>;

/// Joint values of a way of OMPL's, whose angles go the short way round.
std::vector<JointValues> values_along(const og::PathGeometric& path) {
  std::vector<JointValues> way;
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    const auto* s = path.getState(static_cast<unsigned>(i))->as<ob::SE2StateSpace::StateType>();
    JointValues values{s->getX(), s->getY(), s->getYaw() / half_turn * 180};
    if (!way.empty()) values[2] -= 360 * std::round((values[2] - way.back()[2]) / 360);
    way.push_back(values);
  }
  return way;
}

struct PlannerRow {
  int found = 0, collide = 0;
  double median = 0;  ///< seconds of all runs
};

PlannerRow runs_of(const WayProblem& of, const MakePlanner& make, int runs, double limit) {
  auto space = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, of.lo.x);
  bounds.setLow(1, of.lo.y);
  bounds.setHigh(0, of.hi.x);
  bounds.setHigh(1, of.hi.y);
  space->setBounds(bounds);
  PlanMap map;
  map.pieces = of.walls;
  map.robot_pieces = of.mover;
  const auto test = make_fcl_test(map);
  const PathProblem problem = path_problem(of);
  PlannerRow row;
  std::vector<double> seconds;
  for (int run = 1; run <= runs; ++run) {
    ::ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(run));
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(std::make_shared<SampledPoses>(setup.getSpaceInformation(), *test));
    setup.getSpaceInformation()->setStateValidityCheckingResolution(sampled_share);
    ob::ScopedState<ob::SE2StateSpace> start(space);
    start->setXY(of.start[0], of.start[1]);
    start->setYaw(of.start[2] / 180 * half_turn);
    start.enforceBounds();
    setup.addStartState(start);
    setup.setGoal(std::make_shared<GoalRange>(setup.getSpaceInformation(), of.goal_x));
    setup.setPlanner(make(setup.getSpaceInformation()));
    setup.setup();
    const double before = processor_seconds();
    setup.solve(ob::PlannerTerminationCondition([&] { return processor_seconds() - before > limit; }));
    seconds.push_back(processor_seconds() - before);
    if (!setup.haveExactSolutionPath()) continue;
    ++row.found;
    const Answer exact = check(path_scene(problem, values_along(setup.getSolutionPath())));
    if (exact.outcome != Outcome::free) ++row.collide;
  }
  std::nth_element(seconds.begin(), seconds.begin() + runs / 2, seconds.end());
  row.median = seconds[static_cast<std::size_t>(runs / 2)];
  return row;
}

std::string text_of(const PlannerRow& row, int runs) {
  std::string text = 2 * row.found > runs ? fmt::format("{:.3g}", row.median) : "—";
  if (row.found < runs) text += fmt::format(", {} of {}", row.found, runs);
  if (row.collide > 0) text += fmt::format(", {} collide", row.collide);
  return text;
}

}  // namespace

bool compare_ways(int runs, double limit) {
  const std::vector<std::pair<const char*, MakePlanner>> planners = {
      {"RRTConnect", [](const auto& si) { return std::make_shared<og::RRTConnect>(si); }},
      {"KPIECE", [](const auto& si) { return std::make_shared<og::KPIECE1>(si); }},
      {"PRM", [](const auto& si) { return std::make_shared<og::PRM>(si); }}};
  fmt::print("| problem | `find_path()` | RRTConnect | KPIECE | PRM |\n|---|---|---|---|---|\n");
  bool good = true;
  for (const WayProblem& of : way_problems()) {
    const PathProblem problem = path_problem(of);
    std::vector<double> seconds;
    PathAnswer answer;
    for (int run = 0; run < 3; ++run) {
      const double before = processor_seconds();
      answer = find_path(problem);
      seconds.push_back(processor_seconds() - before);
    }
    std::sort(seconds.begin(), seconds.end());
    const bool proved = answer.outcome == PathOutcome::path
                            ? check(path_scene(problem, answer.waypoints)).outcome == Outcome::free
                            : answer.outcome == PathOutcome::none;
    good = good && proved && (answer.outcome == PathOutcome::path) == of.goes;
    fmt::print("| {} | {}, {:.3g} |", of.name, to_string(answer.outcome), seconds[1]);
    for (const auto& [name, make] : planners) {
      // Without a way, each run takes all its time.
      const PlannerRow row = runs_of(of, make, of.goes ? runs : 1, limit);
      fmt::print(" {} |", text_of(row, of.goes ? runs : 1));
      std::fflush(stdout);
    }
    fmt::print("\n");
  }
  return good;
}

}  // namespace taut::bench
