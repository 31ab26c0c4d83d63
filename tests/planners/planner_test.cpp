// find_path() as a planner of OMPL.
#include "taut/for_ompl/planner.hpp"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include "taut/check.hpp"

namespace taut::testing {
namespace {

namespace ob = ::ompl::base;

/// A table before a door of that width in a wall.
PathProblem table(double door) {
  PathProblem problem;
  problem.linkage.joints = {{"x", -3, 3}, {"y", -2, 2}, {"turn", -180, 180}};
  Body wall{"wall", {}, {}};
  wall.parts = {{{{-0.1, door / 2}, {0.1, door / 2}, {0.1, 9}, {-0.1, 9}}, {}},
                {{{-0.1, -9}, {0.1, -9}, {0.1, -door / 2}, {-0.1, -door / 2}}, {}}};
  problem.linkage.scene.bodies = {{"table", {{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}, {}}, wall};
  JointMotion motion;
  motion.kind = FreeMotion{0, 1, 2, {}};
  problem.linkage.motions = {motion, std::nullopt};
  problem.periodic[2] = true;
  return problem;
}

struct Solved {
  ob::PlannerStatus status;
  std::shared_ptr<for_ompl::Planner> planner;
  std::vector<std::array<double, 3>> states;
};

Solved solved(const PathProblem& problem, PathOptions options = {}) {
  ::ompl::msg::noOutputHandler();
  const auto space = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-3);
  bounds.setHigh(3);
  space->setBounds(bounds);
  ::ompl::geometric::SimpleSetup setup(space);
  setup.setStateValidityChecker([](const ob::State*) { return true; });
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  start->setXY(-2, 0.25);
  start->setYaw(1.5);
  goal->setXY(2, 0);
  goal->setYaw(-1.5);
  setup.setStartAndGoalStates(start, goal);
  Solved found;
  found.planner = std::make_shared<for_ompl::Planner>(setup.getSpaceInformation(), problem, options);
  setup.setPlanner(found.planner);
  found.status = setup.solve(10.0);
  if (!setup.haveSolutionPath()) return found;
  for (const ob::State* state : setup.getSolutionPath().getStates()) {
    const auto* at = state->as<ob::SE2StateSpace::StateType>();
    found.states.push_back({at->getX(), at->getY(), at->getYaw()});
  }
  return found;
}

TEST(OmplPlanner, FindsAWayThatIsProved) {
  const Solved found = solved(table(1.05));
  ASSERT_EQ(static_cast<ob::PlannerStatus::StatusType>(found.status), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(check(path_scene(found.planner->problem(), found.planner->answer().waypoints)).outcome, Outcome::free);
  ASSERT_GE(found.states.size(), 3U);
  EXPECT_NEAR(found.states.front()[0], -2, 1e-12);
  EXPECT_NEAR(found.states.front()[2], 1.5, 1e-12);
  EXPECT_NEAR(found.states.back()[0], 2, 1e-12);
  EXPECT_NEAR(found.states.back()[2], -1.5, 1e-12);
  for (std::size_t i = 1; i < found.states.size(); ++i) {
    // The short way round is the one that was proved.
    const double turn = found.states[i][2] - found.states[i - 1][2];
    EXPECT_LT(std::fabs(std::remainder(turn, 2 * M_PI)), M_PI / 2 + 1e-9);
  }
}

TEST(OmplPlanner, ProvesThatThereIsNone) {
  const Solved found = solved(table(0.95));
  EXPECT_EQ(found.planner->answer().outcome, PathOutcome::none);
  EXPECT_TRUE(found.states.empty());
  EXPECT_FALSE(static_cast<bool>(found.status));
}

TEST(OmplPlanner, KeepsToLimitsAndForms) {
  PathOptions few;
  few.max_cells = 3;
  EXPECT_EQ(static_cast<ob::PlannerStatus::StatusType>(solved(table(0.95), few).status), ob::PlannerStatus::TIMEOUT);
  PathProblem plain = table(1.05);
  plain.periodic = {};
  EXPECT_THROW(solved(plain), InputError);
  plain.linkage.joints.pop_back();
  EXPECT_THROW(solved(plain), InputError);
}

}  // namespace
}  // namespace taut::testing
