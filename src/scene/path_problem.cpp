// Is this a problem that can be asked about?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/loop_region.hpp"
#include "scene/linkage.hpp"
#include "taut/error.hpp"
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

InputError out_of_range(const char* where, const Joint& joint, const std::string& values) {
  return InputError(where + ("." + joint.name),
                    fmt::format("{} within the joint's range, [{}, {}]", values, joint.lo, joint.hi),
                    "give a value in the range, or widen it");
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
    require_goal(joints[k], *problem.goal[k]);
  }
  if (!any) throw InputError("goal", "it names no joint", R"(write "goal": {"x": [8, 9]}, or "goal": "outside")");
}

}  // namespace

void internal::require_start(const Joint& joint, double value) {
  if (!(value >= joint.lo && value <= joint.hi)) throw out_of_range("start", joint, fmt::format("{} is not", value));
}

void internal::require_goal(const Joint& joint, const std::array<double, 2>& range) {
  const auto [lo, hi] = range;
  if (std::isfinite(lo) && std::isfinite(hi) && lo <= hi && hi >= joint.lo && lo <= joint.hi) return;
  throw out_of_range("goal", joint,
                     lo == hi ? fmt::format("{} is not", lo) : fmt::format("no value of [{}, {}] is", lo, hi));
}

void validate(const PathProblem& problem) {
  validate(problem.linkage);
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    if (problem.periodic[k]) validate_period(problem, k);
  }
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k)
    require_start(problem.linkage.joints[k], problem.start[k]);
  validate_start_of_loops(problem);
  validate_goal(problem);
}

}  // namespace taut
