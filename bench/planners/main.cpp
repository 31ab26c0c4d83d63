// RRTConnect with sampled validators and with the exact one, on the same maps with the same seeds: which paths are
// found, which of them collide, and what they cost. Then the same edges for each validator.
#include <fmt/format.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "planners/state_tests.hpp"
#include "planners/ways.hpp"
#include "taut/ompl.hpp"

namespace taut::bench {
namespace {

namespace ob = ::ompl::base;
namespace og = ::ompl::geometric;

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Settings {
  int runs = 20;
  double limit = 10;   ///< seconds for each run
  double seconds = 1;  ///< for the edges of each validator
  int edges = 20000;
  std::string folder = "bench/planners";
  std::vector<std::string> only;
  std::vector<std::string> validators;
};

PoseSE2 pose_in(const ob::State* state) {
  const auto* s = state->as<ob::SE2StateSpace::StateType>();
  return {s->getX(), s->getY(), s->getYaw()};
}

class TautTest : public StateTest {
 public:
  TautTest(const PlanMap& map, const StaticMap& prepared) : query_(prepared, prepared.prepare(map.robot)) {}
  bool free(const PoseSE2& pose) override { return query_.at(pose).free(); }

 private:
  MapQuery query_;
};

/// What OMPL's discrete validator samples.
class SampledStates : public ob::StateValidityChecker {
 public:
  SampledStates(const ob::SpaceInformationPtr& si, StateTest& test) : ob::StateValidityChecker(si), test_(test) {}
  bool isValid(const ob::State* state) const override {
    return si_->satisfiesBounds(state) && test_.free(pose_in(state));
  }

 private:
  StateTest& test_;
};

/// A map as planners see it, and the judge of what they find.
struct World {
  PlanMap map;
  StaticMap prepared;
  std::shared_ptr<for_ompl::Robot> robot;
  ob::StateSpacePtr space;

  explicit World(PlanMap of) : map(std::move(of)), prepared(map.bodies) {
    robot = std::make_shared<for_ompl::Robot>(prepared, map.robot);
    auto se2 = std::make_shared<ob::SE2StateSpace>();
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0, map.lo.x);
    bounds.setLow(1, map.lo.y);
    bounds.setHigh(0, map.hi.x);
    bounds.setHigh(1, map.hi.y);
    se2->setBounds(bounds);
    space = se2;
  }
};

struct Validator {
  std::string name;
  double resolution = 0;  ///< 0: exact
  StateTest* test = nullptr;
};

ob::SpaceInformationPtr information(const World& world, const Validator& validator) {
  auto si = std::make_shared<ob::SpaceInformation>(world.space);
  if (validator.test) {
    si->setStateValidityChecker(std::make_shared<SampledStates>(si, *validator.test));
    si->setStateValidityCheckingResolution(validator.resolution);
  } else {
    si->setStateValidityChecker(std::make_shared<for_ompl::StateValidityChecker>(si, world.robot));
    si->setMotionValidator(std::make_shared<for_ompl::MotionValidator>(si, world.robot));
  }
  si->setup();
  return si;
}

ob::State* state_at(const World& world, const PoseSE2& pose) {
  ob::State* state = world.space->allocState();
  auto* s = state->as<ob::SE2StateSpace::StateType>();
  s->setXY(pose.x, pose.y);
  s->setYaw(pose.angle);
  return state;
}

struct Row {
  int found = 0, collide = 0;
  double cpu = 0;
  double edges_a_second = 0;
  int passed = 0, wrong = 0, refused = 0;  ///< edges: passed as free, of these colliding; free ones that were refused
};

bool collides(const og::PathGeometric& path, const ob::MotionValidator& exact) {
  for (std::size_t i = 1; i < path.getStateCount(); ++i) {
    if (!exact.checkMotion(path.getState(static_cast<unsigned>(i - 1)), path.getState(static_cast<unsigned>(i))))
      return true;
  }
  return false;
}

void plan(const World& world, const Validator& validator, const ob::MotionValidator& exact, const Settings& settings,
          Row& row) {
  for (int run = 1; run <= settings.runs; ++run) {
    ::ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(run));
    og::SimpleSetup setup(information(world, validator));
    ob::ScopedState<> start(world.space), goal(world.space);
    start = state_at(world, world.map.start);
    goal = state_at(world, world.map.goal);
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
    setup.setup();
    const double before = cpu_seconds();
    setup.solve(settings.limit);
    row.cpu += cpu_seconds() - before;
    if (!setup.haveExactSolutionPath()) continue;
    ++row.found;
    if (collides(setup.getSolutionPath(), exact)) ++row.collide;
  }
}

/// Edges that a planner would ask about: from a free state, a tenth of the map long at most.
struct Edges {
  std::vector<std::pair<ob::State*, ob::State*>> states;
  std::vector<bool> free;

  Edges(const World& world, const ob::SpaceInformationPtr& exact, int count) {
    ::ompl::RNG::setSeed(12345);
    const ob::StateSamplerPtr sampler = world.space->allocStateSampler();
    const double longest = 0.1 * world.space->getMaximumExtent();
    while (static_cast<int>(states.size()) < count) {
      ob::State *a = world.space->allocState(), *b = world.space->allocState();
      sampler->sampleUniform(a);
      sampler->sampleUniform(b);
      const double way = world.space->distance(a, b);
      if (way > longest) world.space->interpolate(a, b, longest / way, b);
      if (exact->isValid(a)) {
        free.push_back(exact->checkMotion(a, b));
        states.emplace_back(a, b);
      }
    }
  }
};

void time_edges(const World& world, const Validator& validator, const Edges& edges, const Settings& settings,
                Row& row) {
  const ob::SpaceInformationPtr si = information(world, validator);
  const double before = cpu_seconds();
  std::size_t asked = 0;
  for (double spent = 0; spent < settings.seconds; spent = cpu_seconds() - before) {
    for (int k = 0; k < 50; ++k, ++asked) {
      const std::size_t i = asked % edges.states.size();
      const bool passes = si->checkMotion(edges.states[i].first, edges.states[i].second);
      if (asked >= edges.states.size()) continue;
      if (passes) ++row.passed;
      if (passes && !edges.free[i]) ++row.wrong;
      if (!passes && edges.free[i]) ++row.refused;
    }
  }
  row.edges_a_second = static_cast<double>(asked) / (cpu_seconds() - before);
}

void print_row(const World& world, const Validator& validator, const Settings& settings, const Row& row) {
  fmt::print("| {} | {} | {}/{} | {} | {:.2f} | {:.0f} | {} of {} |\n", world.map.name, validator.name, row.found,
             settings.runs, row.collide, row.cpu, row.edges_a_second, row.wrong, row.passed);
  std::fflush(stdout);
  if (row.refused > 0)
    fmt::print(stderr, "{}, {}: {} free edges were refused\n", world.map.name, validator.name, row.refused);
}

bool run_map(PlanMap of, const Settings& settings) {
  const World world(std::move(of));
  const ob::SpaceInformationPtr exact = information(world, {"exact", 0, nullptr});
  const Edges edges(world, exact, settings.edges);
  const auto fcl = make_fcl_test(world.map), box2d = make_box2d_test(world.map);
  TautTest own(world.map, world.prepared);
  std::vector<Validator> validators;
  for (const auto& [name, test] :
       {std::pair<std::string, StateTest*>{"FCL", fcl.get()}, {"Box2D", box2d.get()}, {"taut's states", &own}}) {
    for (const double percent : {1.0, 0.3, 0.1})
      validators.push_back({fmt::format("{}, {} %", name, percent), percent / 100, test});
  }
  validators.push_back({"**exact**", 0, nullptr});
  const auto wanted = [&](const std::string& name) {
    const auto& names = settings.validators;
    return names.empty() || std::any_of(names.begin(), names.end(),
                                        [&](const std::string& part) { return name.find(part) != std::string::npos; });
  };
  bool good = true;
  for (const Validator& validator : validators) {
    if (!wanted(validator.name)) continue;
    Row row;
    plan(world, validator, *exact->getMotionValidator(), settings, row);
    time_edges(world, validator, edges, settings, row);
    print_row(world, validator, settings, row);
    if (!validator.test && (row.collide > 0 || row.wrong > 0 || row.refused > 0)) good = false;
  }
  return good;
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  using namespace taut::bench;
  Settings settings;
  CLI::App app("Planners with sampled validators and with the exact one");
  app.add_option("--runs", settings.runs, "runs of the planner for each row (20)");
  app.add_option("--limit", settings.limit, "seconds for each run (10)");
  app.add_option("--seconds", settings.seconds, "seconds for the edges of each row (1)");
  app.add_option("--edges", settings.edges, "different edges for each map (20000)");
  app.add_option("--folder", settings.folder, "where trondheimsfjord.wkt is (bench/planners)");
  app.add_option("--only", settings.only, "names of maps");
  app.add_option("--validators", settings.validators, "parts of names of validators");
  bool ways = false;
  app.add_flag("--ways", ways, "narrow passages instead: planners of OMPL beside find_path()");
  CLI11_PARSE(app, argc, argv);
  ::ompl::msg::setLogLevel(::ompl::msg::LOG_NONE);
  try {
    if (ways) return compare_ways(settings.runs, settings.limit) ? 0 : 1;
    fmt::print("| map | validator | found | collide | CPU, s | edges a second | edges passed that collide |\n");
    fmt::print("|---|---|---|---|---|---|---|\n");
    bool good = true;
    for (PlanMap& map : plan_maps(settings.folder)) {
      const auto& only = settings.only;
      if (!only.empty() && std::find(only.begin(), only.end(), map.name) == only.end()) continue;
      good = run_map(std::move(map), settings) && good;
    }
    return good ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
