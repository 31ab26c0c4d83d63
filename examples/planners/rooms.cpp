// A T-shaped robot carries itself through the doors of a flat: RRTConnect in SE(2), every edge exact.
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "picture.hpp"

int main() {
  using namespace planning;
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  ompl::RNG::setSeed(1);
  // Walls of 10 cm, in which doors of 90 cm are.
  const auto wall = [](const char* name, double x0, double y0, double x1, double y1) {
    return taut::Body{name, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
  };
  const taut::StaticMap flat({wall("west", -0.1, -0.1, 0, 6.1), wall("east", 8, -0.1, 8.1, 6.1),
                              wall("south", 0, -0.1, 8, 0), wall("north", 0, 6, 8, 6.1), wall("hall 1", 3, 0, 3.1, 3.5),
                              wall("hall 2", 3, 4.4, 3.1, 6), wall("kitchen 1", 5.4, 0, 5.5, 0.8),
                              wall("kitchen 2", 5.4, 1.7, 5.5, 6), wall("bath 1", 5.5, 3, 6.4, 3.1),
                              wall("bath 2", 7.3, 3, 8, 3.1)});
  taut::Body tee{
      "tee",
      {{-0.05, -0.4}, {0.05, -0.4}, {0.05, 0.3}, {0.4, 0.3}, {0.4, 0.4}, {-0.4, 0.4}, {-0.4, 0.3}, {-0.05, 0.3}},
      {}};
  const auto robot = std::make_shared<taut::for_ompl::Robot>(flat, tee);

  auto space = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0);
  bounds.setHigh(0, 8);
  bounds.setHigh(1, 6);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
  si->setStateValidityChecker(std::make_shared<taut::for_ompl::StateValidityChecker>(si, robot));
  si->setMotionValidator(std::make_shared<taut::for_ompl::MotionValidator>(si, robot));
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  start->setXY(1, 1);
  start->setYaw(0);
  goal->setXY(7, 5);
  goal->setYaw(3);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(si));
  setup.solve(20);
  Picture picture(-0.2, -0.2, 8.2, 6.2);
  return report(setup, *robot, picture, "rooms");
}
