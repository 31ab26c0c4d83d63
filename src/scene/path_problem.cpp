// Is this a problem that can be asked about, and where are its bodies along a way?
#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/loop_region.hpp"
#include "scene/linkage.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"
#include "taut/path.hpp"

namespace taut {
using namespace internal;
namespace {

/// Bodies have to be where they were after a period.
void validate_period(const PathProblem& problem, std::size_t joint) {
  const Joint& j = problem.linkage.joints[joint];
  for (std::size_t i = 0; i < problem.linkage.motions.size(); ++i) {
    if (!problem.linkage.motions[i]) continue;
    for (const JointMotion& motion : single_motions(*problem.linkage.motions[i])) {
      if (static_cast<std::size_t>(motion.joint) != joint) continue;
      if (std::holds_alternative<LinkMotion>(motion.kind))
        throw InputError("periodic." + j.name, "it drives a mechanism, which is not known to come back to where it was",
                         "leave it out of \"periodic\"");
      const double turns = motion.times * (j.hi - j.lo) / 360;
      if (std::holds_alternative<Revolute>(motion.kind) && turns == std::floor(turns) && turns != 0) continue;
      throw InputError(
          "periodic." + j.name,
          "over its range, body \"" + problem.linkage.scene.bodies[i].name + "\" does not come back to where it was",
          "give the joint a range of 360 degrees, or leave it out of \"periodic\"");
    }
  }
}

void validate_start(const PathProblem& problem) {
  const std::vector<Joint>& joints = problem.linkage.joints;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (problem.start[k] >= joints[k].lo && problem.start[k] <= joints[k].hi) continue;
    throw InputError("start." + joints[k].name, "it is not within the joint's range",
                     "give a value in the range, or widen it");
  }
}

/// A way begins where the drives go to straight from the drawn pose.
void validate_start_of_loops(const PathProblem& problem) {
  for (const DrivenLoops& loops : problem.linkage.loops) {
    if (loops.region && !loops.region->has_straight_way(problem.start))
      throw InputError("start", "the mechanism may lock on the straight way from the drawn pose to there",
                       "start nearer to the drawn pose, at which all driven joints have the value 0");
  }
}

void validate_goal(const PathProblem& problem) {
  const std::vector<Joint>& joints = problem.linkage.joints;
  bool any = problem.goal_outside;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!problem.goal[k]) continue;
    any = true;
    const auto& [lo, hi] = *problem.goal[k];
    if (!std::isfinite(lo) || !std::isfinite(hi) || hi < lo || hi < joints[k].lo || lo > joints[k].hi)
      throw InputError("goal." + joints[k].name, "no value of it is within the joint's range",
                       "give a value in the range, or widen it");
  }
  if (!any) throw InputError("goal", "it names no joint", R"(write "goal": {"x": [8, 9]}, or "goal": "outside")");
}

}  // namespace

void validate(const PathProblem& problem) {
  validate(problem.linkage);
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    if (problem.periodic[k]) validate_period(problem, k);
  }
  validate_start(problem);
  validate_start_of_loops(problem);
  validate_goal(problem);
}

namespace {

/// The driven joints of a mechanism move from waypoint to waypoint. Its links have neither motions nor parents yet.
void drive_along(const PathProblem& problem, const std::vector<JointValues>& waypoints, Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto& motion = problem.linkage.motions[i];
    if (motion && std::holds_alternative<LinkMotion>(motion->kind)) scene.bodies[i].relative_to.clear();
  }
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    const std::string& name = problem.linkage.joints[k].name;
    if (!is_joint_of(*scene.mechanism, name)) continue;
    Drive drive{name, {}};
    for (std::size_t n = 1; n < waypoints.size(); ++n) {
      const auto t = static_cast<double>(n);
      drive.pieces.push_back({t, std::array<double, 4>{t - 1, waypoints[n - 1][k], t, waypoints[n][k]}, {}});
    }
    if (drive.pieces.empty()) {
      drive.pieces.emplace_back();
      drive.pieces.back().polynomial = {waypoints[0][k]};
    }
    drive.pieces.back().until = std::numeric_limits<double>::infinity();
    scene.mechanism->drives.push_back(std::move(drive));
  }
}

}  // namespace

Scene path_scene(const PathProblem& problem, const std::vector<JointValues>& waypoints) {
  Scene scene = problem.linkage.scene;
  scene.start = 0;
  scene.end = static_cast<double>(waypoints.size()) - 1;
  if (scene.mechanism) drive_along(problem, waypoints, scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    scene.bodies[i].motion = {};
    if (i >= problem.linkage.motions.size() || !problem.linkage.motions[i]) continue;
    if (std::holds_alternative<LinkMotion>(problem.linkage.motions[i]->kind)) continue;
    std::vector<Keyframe> frames(waypoints.size());
    Point pivot;
    for (const JointMotion& motion : single_motions(*problem.linkage.motions[i])) {
      if (const auto* revolute = std::get_if<Revolute>(&motion.kind)) pivot = revolute->pivot;
      for (std::size_t n = 0; n < waypoints.size(); ++n) {
        const double value = motion.times * waypoints[n][static_cast<std::size_t>(motion.joint)] + motion.plus;
        frames[n].t = static_cast<double>(n);
        if (const auto* slide = std::get_if<Slide>(&motion.kind)) {
          frames[n].x += value * slide->direction.x;
          frames[n].y += value * slide->direction.y;
        } else {
          frames[n].angle_deg = value;
        }
      }
    }
    scene.bodies[i].motion = from_keyframes(frames, pivot);
  }
  return assembled(std::move(scene));
}

}  // namespace taut
