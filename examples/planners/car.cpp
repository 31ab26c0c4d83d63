// A car parks between two others: RRT in the space of Reeds-Shepp curves, whose arcs are checked as arcs.
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "picture.hpp"

int main() {
  using namespace planning;
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  ompl::RNG::setSeed(1);
  const auto block = [](const char* name, double x0, double y0, double x1, double y1) {
    return taut::Body{name, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
  };
  const taut::StaticMap street({block("kerb", 0, -0.3, 24, 0), block("houses", 0, 7, 24, 7.3),
                                block("car in front", 14.6, 0.3, 19, 2.1), block("car behind", 3, 0.3, 8.2, 2.1),
                                block("skip", 9.5, 5.2, 11.5, 7)});
  // The origin is in the middle of the rear axle.
  const taut::Body car{"car", {{-0.9, -0.9}, {3.4, -0.9}, {3.6, -0.6}, {3.6, 0.6}, {3.4, 0.9}, {-0.9, 0.9}}, {}};
  const auto robot = std::make_shared<taut::for_ompl::Robot>(street, car);

  auto space = std::make_shared<ob::ReedsSheppStateSpace>(4.0);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0);
  bounds.setHigh(0, 24);
  bounds.setHigh(1, 7);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  const ob::SpaceInformationPtr& si = setup.getSpaceInformation();
  si->setStateValidityChecker(std::make_shared<taut::for_ompl::StateValidityChecker>(si, robot));
  si->setMotionValidator(std::make_shared<taut::for_ompl::MotionValidator>(si, robot));
  ob::ScopedState<ob::ReedsSheppStateSpace> start(space), goal(space);
  start->setXY(1.5, 3.6);
  start->setYaw(0);
  goal->setXY(10, 1.2);
  goal->setYaw(0);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(si));
  setup.solve(20);
  Picture picture(-0.2, -0.5, 24.2, 7.5);
  return report(setup, *robot, picture, "car");
}
