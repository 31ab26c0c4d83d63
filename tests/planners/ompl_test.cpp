// Planners' validators against dense samples of OMPL's own interpolation, and against what they promise.
#include "taut/ompl.hpp"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <sstream>
#include <thread>

#include "planners/planning.hpp"
#include "support/effort.hpp"
#include "taut/pose.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

struct EdgeCounts {
  int free = 0, blocked = 0, advanced = 0, close = 0;
};

/// How far the first sample that certainly overlaps is along the edge; 2 if there is none. What is tested is a robot
/// that is smaller by far more than rounding.
double first_blocked(const Planning& exact, const Planning& smaller, const ob::State* a, const ob::State* b,
                     int samples) {
  ob::State* at = exact.si->allocState();
  double found = 2;
  for (int i = 0; i <= samples && found > 1; ++i) {
    const double t = static_cast<double>(i) / samples;
    exact.space->interpolate(a, b, t, at);
    const for_ompl::Robot::Borrowed asker(*smaller.robot);
    for_ompl::Steering steering(*exact.space, *smaller.robot);
    steering.poses(at, asker->coordinates, asker->from);
    if (!asker->query.at(asker->from).free()) found = t;
  }
  exact.si->freeState(at);
  return found;
}

/// A free edge has no sample that overlaps; of a blocked one, the last valid state is valid, no sample before it is
/// not, and soon after it a state is not.
void expect_true_verdicts(const Planning& exact, const Planning& smaller, Rng& rng, int edges, int side,
                          EdgeCounts& counts) {
  for (int i = 0; i < edges; ++i) {
    SCOPED_TRACE("edge " + std::to_string(i));
    ob::State *a = exact.random_state(rng, -2.5, 4.0 * side - 0.5),
              *b = exact.random_state(rng, -2.5, 4.0 * side - 0.5);
    ob::State* last = exact.si->allocState();
    if (rng.chance(0.5)) exact.space->interpolate(a, b, 0.3, b);
    if (exact.si->isValid(a)) {
      std::pair<ob::State*, double> valid{last, -1};
      const bool free = exact.motions->checkMotion(a, b, valid);
      EXPECT_EQ(exact.motions->checkMotion(a, b), free);
      const double blocked = first_blocked(exact, smaller, a, b, 300);
      if (free) {
        EXPECT_EQ(blocked, 2);
        EXPECT_EQ(valid.second, -1);
        ++counts.free;
      } else {
        EXPECT_GE(blocked, valid.second - 1e-9);
        EXPECT_TRUE(exact.si->isValid(last));
        EXPECT_GE(valid.second, 0);
        EXPECT_LE(valid.second, 1);
        ob::State* at = exact.si->allocState();
        exact.space->interpolate(a, b, valid.second, at);
        EXPECT_TRUE(valid.second == 0 || exact.space->equalStates(at, last));
        exact.si->freeState(at);
        ++counts.blocked;
        if (valid.second > 0) ++counts.advanced;
        // The contact may be a brush against a corner, but most go on to where a sample sees them.
        if (blocked < valid.second + 2.0 / 300) ++counts.close;
      }
    }
    exact.si->freeState(a);
    exact.si->freeState(b);
    exact.si->freeState(last);
  }
}

template <class Make>
EdgeCounts examined_edges(std::uint64_t seed, const Make& make_space, int edges) {
  EdgeCounts counts;
  for (std::uint64_t k = seed; k < seed + effort(20); ++k) {
    SCOPED_TRACE("seed " + std::to_string(k));
    Rng rng(k);
    const int side = rng.between(1, 4);
    const StaticMap map(star_obstacles(rng, side), 2);
    const Body body = star_body(rng, "robot", rng.real(0.1, 0.6));
    Body less = body;
    for (Part& part : less.parts) {
      for (Point& p : part.outline) p = {p.x * (1 - 1e-9), p.y * (1 - 1e-9)};
    }
    const Planning exact(make_space(side), std::make_shared<for_ompl::Robot>(map, body));
    const Planning smaller(make_space(side), std::make_shared<for_ompl::Robot>(map, less));
    expect_true_verdicts(exact, smaller, rng, edges, side, counts);
    EXPECT_EQ(exact.motions->undecided(), 0u);
    EXPECT_EQ(exact.states->undecided(), 0u);
  }
  return counts;
}

TEST(Ompl, StraightEdges) {
  const EdgeCounts counts = examined_edges(
      1,
      [](int side) {
        auto space = std::make_shared<ob::SE2StateSpace>();
        set_bounds(*space, side);
        return space;
      },
      40);
  EXPECT_GE(counts.free, static_cast<int>(enough(60)));
  EXPECT_GE(counts.blocked, static_cast<int>(enough(200)));
  EXPECT_GE(counts.advanced, static_cast<int>(enough(200)));
  EXPECT_GE(counts.close, 0.9 * counts.blocked);
}

TEST(Ompl, DubinsEdges) {
  for (const bool symmetric : {false, true}) {
    const EdgeCounts counts = examined_edges(
        symmetric ? 2000 : 1000,
        [symmetric](int side) {
          auto space = std::make_shared<ob::DubinsStateSpace>(0.7, symmetric);
          set_bounds(*space, side);
          return space;
        },
        25);
    EXPECT_GE(counts.free, static_cast<int>(enough(30)));
    EXPECT_GE(counts.blocked, static_cast<int>(enough(100)));
    EXPECT_GE(counts.close, 0.6 * counts.blocked);
  }
}

TEST(Ompl, ReedsSheppEdges) {
  const EdgeCounts counts = examined_edges(
      3000,
      [](int side) {
        auto space = std::make_shared<ob::ReedsSheppStateSpace>(0.7);
        set_bounds(*space, side);
        return space;
      },
      25);
  EXPECT_GE(counts.free, static_cast<int>(enough(30)));
  EXPECT_GE(counts.blocked, static_cast<int>(enough(100)));
}

/// The motion that is proved, at time t.
PoseSE2 pose_of_motion(const Motion& motion, double t) {
  const BodyPose pose = pose_at(motion, t);
  return {pose.origin.x, pose.origin.y, std::atan2(pose.axis.y, pose.axis.x)};
}

/// OMPL's interpolation and the motion, all along.
template <class Space>
double farthest_apart(const std::shared_ptr<Space>& shared, Rng& rng) {
  const Space& space = *shared;
  double farthest = 0;
  ob::ScopedState<Space> a(shared), b(a), at(a);
  const auto draw = [&](ob::ScopedState<Space>& s) {
    s->setXY(rng.real(-5, 5), rng.real(-5, 5));
    s->setYaw(rng.real(-3.1, 3.1));
  };
  draw(a);
  draw(b);
  const for_ompl::Curve curve = for_ompl::curve_between(space, a.get(), b.get());
  Motion motion;
  double end = 0;
  {
    for_ompl::PieceWriter pieces(motion);
    end = for_ompl::write_curve(curve, {a->getX(), a->getY(), a->getYaw()}, {b->getX(), b->getY(), b->getYaw()}, 0,
                                pieces);
  }
  EXPECT_NEAR(end, curve.length(), 1e-12);
  for (int i = 0; i < 100; ++i) {
    space.interpolate(a.get(), b.get(), i / 100.0, at.get());
    const PoseSE2 pose = pose_of_motion(motion, end * (i / 100.0));
    farthest = std::max({farthest, std::fabs(pose.x - at->getX()), std::fabs(pose.y - at->getY()),
                         std::fabs(std::remainder(pose.angle - at->getYaw(), 2 * for_ompl::pi))});
  }
  const PoseSE2 last = pose_of_motion(motion, end + for_ompl::closing_time);
  EXPECT_NEAR(last.x, b->getX(), 1e-14);
  EXPECT_NEAR(last.y, b->getY(), 1e-14);
  EXPECT_NEAR(std::remainder(last.angle - b->getYaw(), 2 * for_ompl::pi), 0, 1e-14);
  return farthest;
}

TEST(Ompl, CurvesAreThoseOfTheSpace) {
  Rng rng(9);
  for (std::uint64_t i = 0; i < effort(300); ++i) {
    EXPECT_LT(farthest_apart(std::make_shared<ob::DubinsStateSpace>(rng.real(0.2, 2)), rng), 1e-13);
    EXPECT_LT(farthest_apart(std::make_shared<ob::DubinsStateSpace>(rng.real(0.2, 2), true), rng), 1e-13);
    EXPECT_LT(farthest_apart(std::make_shared<ob::ReedsSheppStateSpace>(rng.real(0.2, 2)), rng), 1e-13);
  }
}

ob::StateSpacePtr arm_space(int joints, double low, double high) {
  auto space = std::make_shared<ob::CompoundStateSpace>();
  auto base = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(low);
  bounds.setHigh(high);
  base->setBounds(bounds);
  space->addSubspace(base, 1);
  for (int i = 0; i < joints; ++i) space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 0.5);
  return space;
}

/// The links of a chain, as a scene with parents says it, for samples of an edge.
TEST(Ompl, ChainsOfLinks) {
  int free = 0, blocked = 0;
  for (std::uint64_t seed = 50; seed < 50 + effort(20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int side = rng.between(1, 3);
    const std::vector<Body> town = star_obstacles(rng, side);
    std::vector<for_ompl::Link> links{{star_body(rng, "base", 0.4)},
                                      {star_body(rng, "upper", 0.3), 0, {0.7, 0.1}},
                                      {star_body(rng, "lower", 0.25), 1, {0.6, 0}}};
    const Planning arm(arm_space(2, -3, 4.0 * side), std::make_shared<for_ompl::Robot>(StaticMap(town, 2), links));
    for (int i = 0; i < 20; ++i) {
      ob::State *a = arm.random_state(rng, -2.5, 4.0 * side - 0.5), *b = arm.random_state(rng, -2.5, 4.0 * side - 0.5);
      if (arm.si->isValid(a)) {
        const bool passes = arm.motions->checkMotion(a, b);
        ob::State* at = arm.si->allocState();
        bool sampled = true;
        for (int k = 1; k <= 200 && sampled; ++k) {
          arm.space->interpolate(a, b, k / 200.0, at);
          Scene scene;
          scene.bodies = town;
          std::vector<double> values;
          arm.space->copyToReals(values, at);
          for (std::size_t link = 0; link < 3; ++link) {
            Body body = links[link].shape;
            const Point o = link == 0 ? Point{values[0], values[1]} : links[link].joint;
            body.motion.pieces = {{{o.x}, {o.y}, AngleRotation{{values[2 + link]}}}};
            if (link > 0) {
              body.relative_to = links[link - 1].shape.name;
              scene.ignore.push_back({body.name, body.relative_to});
            }
            scene.bodies.push_back(body);
          }
          sampled = k % 20 != 0 || check(scene).outcome != Outcome::overlap_at_start;
        }
        if (passes) {
          EXPECT_TRUE(sampled);
        }
        ++(passes ? free : blocked);
        arm.si->freeState(at);
      }
      arm.si->freeState(a);
      arm.si->freeState(b);
    }
  }
  EXPECT_GE(free, static_cast<int>(enough(20)));
  EXPECT_GE(blocked, static_cast<int>(enough(60)));
}

/// A planner on two threads asks one validator; what it finds is proved.
TEST(Ompl, ThreadsAndPlanners) {
  ::ompl::msg::setLogLevel(::ompl::msg::LOG_ERROR);
  Rng rng(4);
  const StaticMap map(star_obstacles(rng, 4), 2);
  auto space = std::make_shared<ob::SE2StateSpace>();
  set_bounds(*space, 4);
  const Planning planning(space, std::make_shared<for_ompl::Robot>(map, star_body(rng, "robot", 0.4)));
  std::vector<ob::State*> states;
  for (int i = 0; i < 300; ++i) states.push_back(planning.random_state(rng, -2, 15));
  const auto ask = [&](std::vector<bool>& said) {
    for (std::size_t i = 1; i < states.size(); ++i)
      said.push_back(planning.motions->checkMotion(states[i - 1], states[i]));
  };
  std::vector<bool> alone, first, second;
  ask(alone);
  std::thread one([&] { ask(first); }), two([&] { ask(second); });
  one.join();
  two.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
  EXPECT_EQ(planning.motions->getCheckedMotionCount(), 3 * 299u);
  for (ob::State* s : states) planning.si->freeState(s);

  ::ompl::geometric::SimpleSetup setup(planning.si);
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space);
  start->setXY(-2, -2);
  start->setYaw(0);
  goal->setXY(14.5, 14.5);
  goal->setYaw(1);
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<::ompl::geometric::RRTConnect>(planning.si));
  ASSERT_TRUE(setup.solve(20.0));
  ASSERT_TRUE(setup.haveExactSolutionPath());
  EXPECT_TRUE(setup.getSolutionPath().check());
  const Scene scene = for_ompl::path_scene(*planning.robot, *space, setup.getSolutionPath().getStates());
  EXPECT_EQ(scene.end, static_cast<double>(setup.getSolutionPath().getStateCount() - 1));
  std::stringstream log;
  EXPECT_EQ(prove(scene, log).outcome, Outcome::free);
  EXPECT_EQ(verify(scene, log).outcome, Outcome::free);
}

/// A path of curves, and one of an arm, are scenes whose check agrees with that of all edges.
TEST(Ompl, PathsAsScenes) {
  int free = 0, blocked = 0;
  for (std::uint64_t seed = 400; seed < 400 + effort(30); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const int side = 3;
    const StaticMap map(star_obstacles(rng, side), 2);
    ob::StateSpacePtr space = arm_space(1, -3, 4.0 * side);
    std::vector<for_ompl::Link> links{{star_body(rng, "base", 0.3)}, {star_body(rng, "arm", 0.2), 0, {0.5, 0}}};
    if (seed % 2 == 0) {
      const auto car = std::make_shared<ob::ReedsSheppStateSpace>(0.5);
      set_bounds(*car, side);
      space = car;
      links.pop_back();
    }
    const Planning planning(space, std::make_shared<for_ompl::Robot>(map, links));
    std::vector<ob::State*> states{planning.random_state(rng, -2.5, 11)};
    bool free_edges = planning.si->isValid(states[0]);
    for (int i = 0; i < 4; ++i) {
      states.push_back(planning.random_state(rng, -2.5, 11));
      space->interpolate(states[static_cast<std::size_t>(i)], states.back(), 0.2, states.back());
      free_edges = planning.motions->checkMotion(states[static_cast<std::size_t>(i)], states.back()) && free_edges;
    }
    const Answer answer = check(for_ompl::path_scene(*planning.robot, *space, states));
    // A curve that leaves the bounds is no valid edge, but meets nothing there.
    if (free_edges) {
      EXPECT_EQ(answer.outcome, Outcome::free);
    } else if (seed % 2 == 1) {
      EXPECT_NE(answer.outcome, Outcome::free);
    }
    ++(free_edges ? free : blocked);
    for (ob::State* s : states) planning.si->freeState(s);
  }
  EXPECT_GE(free, static_cast<int>(enough(2)));
  EXPECT_GE(blocked, static_cast<int>(enough(10)));
}

TEST(Ompl, SpacesThatDoNotFit) {
  Rng rng(1);
  const StaticMap map(star_obstacles(rng, 2), 2);
  const auto one = std::make_shared<for_ompl::Robot>(map, star_body(rng, "robot", 0.4));
  const auto arm = std::make_shared<for_ompl::Robot>(
      map, std::vector<for_ompl::Link>{{star_body(rng, "base", 0.4)}, {star_body(rng, "arm", 0.3), 0, {0.5, 0}}});
  const auto fault = [](const ob::StateSpacePtr& space, const std::shared_ptr<for_ompl::Robot>& robot) -> std::string {
    try {
      const for_ompl::Steering steering(*space, *robot);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was refused";
  };
  EXPECT_NE(fault(std::make_shared<ob::RealVectorStateSpace>(5), one).find("5 coordinates"), std::string::npos);
  EXPECT_EQ(fault(std::make_shared<ob::RealVectorStateSpace>(2), one), "nothing was refused");
  EXPECT_EQ(fault(std::make_shared<ob::RealVectorStateSpace>(2), arm), "nothing was refused");
  EXPECT_NE(fault(std::make_shared<ob::DubinsStateSpace>(), arm).find("3 coordinates"), std::string::npos);
  EXPECT_NE(fault(std::make_shared<ob::DiscreteStateSpace>(0, 3), one).find("real coordinates and planar angles"),
            std::string::npos);
}

/// On a layer without any body no state would be valid, and no planner would say why.
TEST(Ompl, RobotsThatCanMeetNothingAreRefused) {
  Rng rng(1);
  std::vector<Body> walls = star_obstacles(rng, 2);
  for (Body& wall : walls) wall.z = {0, 1};
  const StaticMap map(walls, 2);
  Body robot = star_body(rng, "robot", 0.4);
  robot.z = {0, 2};
  EXPECT_NO_THROW(for_ompl::Robot(map, robot));
  robot.z = {1, 2};
  EXPECT_THROW(for_ompl::Robot(map, robot), InputError);
}

}  // namespace
}  // namespace taut::testing
