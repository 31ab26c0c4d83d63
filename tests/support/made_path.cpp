#include "support/made_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_world.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"

namespace taut::testing {

JointMotion freely(std::optional<int> x, std::optional<int> y, std::optional<int> deg, Point pivot) {
  JointMotion motion;
  motion.kind = FreeMotion{x, y, deg, pivot};
  return motion;
}

PathProblem random_problem(Rng& rng, int dimension) {
  PathProblem problem;
  std::vector<int> joints;
  for (int k = 0; k < dimension; ++k) {
    const bool turn = k == 2;
    problem.linkage.joints.push_back({std::string(1, static_cast<char>('a' + k)), turn ? 0.0 : -2, turn ? 360.0 : 2});
  }
  problem.periodic[2] = dimension == 3;
  Body mover{"mover", {}, {}}, rest{"rest", {}, {}};
  mover.parts = {star_part(rng, {0, 0}, rng.real(0.3, 0.8), 0)};
  for (int n = rng.between(2, 4); n > 0; --n)
    rest.parts.push_back(star_part(rng, {rng.real(-2, 2), rng.real(-2, 2)}, rng.real(0.4, 1), 0));
  problem.linkage.scene.bodies = {mover, rest};
  problem.linkage.motions = {
      freely(0, 1, dimension == 3 ? std::optional(2) : std::nullopt, {rng.real(-0.5, 0.5), rng.real(-0.5, 0.5)}),
      std::nullopt};
  for (std::size_t k = 0; k < 2; ++k) {
    problem.start[k] = rng.real(-2, 2);
    const double goal = rng.real(-2, 2);
    problem.goal[k] = {goal, goal};
  }
  return problem;
}

PathProblem random_linkage(std::uint64_t seed) {
  Rng rng(seed);
  PathProblem problem;
  Linkage& linkage = problem.linkage;
  const int joints = rng.between(1, 4);
  for (int k = 0; k < joints; ++k) {
    const double lo = rng.real(-120, 60);
    linkage.joints.push_back({"joint " + std::to_string(k), lo, lo + rng.real(5, 150)});
  }
  const Scene shapes = scene_of(random_world(seed));
  linkage.scene.bodies.assign(shapes.bodies.begin(),
                              shapes.bodies.begin() + std::min<std::ptrdiff_t>(4, std::ssize(shapes.bodies)));
  linkage.motions.resize(linkage.scene.bodies.size());
  for (std::size_t i = 0; i < linkage.scene.bodies.size(); ++i) {
    Body& body = linkage.scene.bodies[i];
    body.motion = {};
    body.relative_to = i > 0 && rng.chance(0.5) ? linkage.scene.bodies[i - 1].name : "";
    if (!rng.chance(0.8)) continue;
    JointMotion motion;
    const Point vector{rng.real(-1, 1), rng.real(-1, 1)};
    if (rng.chance(0.5)) {
      motion.kind = Revolute{vector};
    } else if (rng.chance(0.5)) {
      motion.kind = Slide{{vector.x / 50, vector.y / 50}};
    } else {
      const auto some = [&] { return rng.chance(0.7) ? std::optional(rng.below(joints)) : std::nullopt; };
      motion.kind = FreeMotion{{}, some(), rng.below(joints), vector};
    }
    motion.joint = rng.below(joints);
    motion.times = rng.chance(0.5) ? 1 : rng.real(-2, 2);
    motion.plus = rng.chance(0.5) ? 0 : rng.real(-40, 40);
    linkage.motions[i] = motion;
  }
  return problem;
}

void expect_proved(const PathProblem& problem, const PathAnswer& answer, const PathOptions& options) {
  ASSERT_EQ(answer.outcome, PathOutcome::path) << answer.reason;
  ASSERT_GE(answer.waypoints.size(), 2U);
  const Scene scene = path_scene(problem, answer.waypoints);
  CheckOptions check_options;
  check_options.touch = options.touch;
  if (options.clearance > 0) {
    check_options.touch = Touch::open;
    EXPECT_EQ(check_clearance(scene, options.clearance, check_options).outcome, Outcome::free);
  } else {
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
      check_options.engine = engine;
      EXPECT_EQ(check(scene, check_options).outcome, Outcome::free);
    }
  }
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    const Joint& joint = problem.linkage.joints[k];
    EXPECT_EQ(answer.waypoints.front()[k], problem.start[k]);
    for (const JointValues& at : answer.waypoints) {
      if (!problem.periodic[k]) {
        EXPECT_TRUE(at[k] >= joint.lo && at[k] <= joint.hi);
      }
    }
    if (!problem.goal[k]) continue;
    const double period = joint.hi - joint.lo, last = answer.waypoints.back()[k];
    const double turned =
        problem.periodic[k] ? last - period * std::floor((last - (*problem.goal[k])[0]) / period + 1e-12) : last;
    EXPECT_GE(turned, (*problem.goal[k])[0] - 1e-9);
    EXPECT_LE(turned, (*problem.goal[k])[1] + 1e-9);
  }
}

}  // namespace taut::testing
