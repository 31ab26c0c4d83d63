// The question: is there any way?
#include "path/path_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "numeric/budget.hpp"
#include "path/shortest.hpp"
#include "path/translations.hpp"
#include "scene/untested.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
using namespace internal::path;
namespace {

void validate_options(const PathOptions& options) {
  if (!(options.tolerance >= 1e-9 && options.tolerance <= 1))
    throw InputError("tolerance", "it is not between 1e-9 and 1", "it is a share of each joint's range");
  if (!(options.within >= 0 && options.within <= 1e6))
    throw InputError("within", "it is not between 0 and 1e6", "it is a share of the length of the shortest way");
  if (!(options.clearance >= 0 && options.clearance < INFINITY))
    throw InputError("clearance", "it is no distance", "give a length of at least 0, in the scene's units");
}

std::string quoted(const PathProblem& problem, BodyId body) {
  return "\"" + problem.linkage.scene.bodies[static_cast<std::size_t>(body)].name + "\"";
}

std::string collision_text(const PathProblem& problem, const PathOptions& options, const StillCollision& found) {
  const auto& [a, b] = *found.pair;
  return quoted(problem, a) + " and " + quoted(problem, b) +
         (options.clearance > 0            ? " are nearer than the clearance"
          : options.touch == Touch::closed ? " collide or touch"
                                           : " collide");
}

/// All of {-1, 0, 1}^joints, those that move few joints first.
std::vector<JointValues> sides_of(std::size_t joints) {
  std::vector<JointValues> sides(1);
  for (std::size_t k = 0; k < joints; ++k) {
    const std::size_t n = sides.size();
    for (const double by : {-1.0, 1.0}) {
      for (std::size_t i = 0; i < n; ++i) {
        sides.push_back(sides[i]);
        sides.back()[k] = by;
      }
    }
  }
  const auto kept = [](const JointValues& side) { return std::count(side.begin(), side.end(), 0.0); };
  std::stable_sort(sides.begin(), sides.end(),
                   [&](const JointValues& a, const JointValues& b) { return kept(a) > kept(b); });
  return sides;
}

/// Values of the joints a little away, at which certainly nothing collides, if there are some: on all sides, ever
/// farther, up to a sixteenth of the ranges.
std::optional<JointValues> free_nearby(const PathProblem& problem, const JointSpace& space, const JointValues& values) {
  const std::vector<Joint>& joints = problem.linkage.joints;
  const std::vector<JointValues> sides = sides_of(joints.size());
  for (int exponent = -24; exponent <= -4; ++exponent) {
    for (const JointValues& side : sides) {
      JointValues near = values;
      for (std::size_t k = 0; k < joints.size(); ++k) {
        const Joint& joint = joints[k];
        near[k] = std::clamp(values[k] + side[k] * std::ldexp(joint.hi - joint.lo, exponent), joint.lo, joint.hi);
      }
      if (space.is_free(near)) return near;
    }
  }
  return std::nullopt;
}

/// Throws InputError where bodies collide at what the problem states; nothing if the engines do not decide that.
void require_free(const PathProblem& problem, const PathOptions& options, const JointSpace& space,
                  const WayChecker& checker, const JointValues& values, const char* where) {
  const std::optional<StillCollision> found = checker.collision_at(values);
  if (!found || found->undecided || !found->pair) return;
  std::string hint = "give joint values at which no bodies collide";
  if (const auto near = free_nearby(problem, space, values)) {
    hint += "; near these, none do at ";
    for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k)
      hint += fmt::format("{}{} = {:.9g}", k ? ", " : "", problem.linkage.joints[k].name, (*near)[k]);
  }
  throw InputError(where, collision_text(problem, options, *found), hint);
}

/// Are there no values of the joints that the mechanism can have in another pose than the one that it gets into
/// straight from the drawn pose? Where several drives move a loop, there may be.
bool has_one_pose(const Linkage& linkage) {
  return std::none_of(linkage.loops.begin(), linkage.loops.end(),
                      [](const DrivenLoops& loops) { return loops.region != nullptr; });
}

void search(const PathProblem& problem, const PathOptions& options, const OnNone& on_none, PathAnswer& answer) {
  const JointSpace space(problem, options.clearance);
  answer.coverage = space.pairs().coverage();
  if (answer.coverage.is_empty()) {
    answer.outcome = PathOutcome::untested;
    answer.reason = why_untested(answer.coverage);
    return;
  }
  if (const auto& overlap = space.pairs().overlap())
    throw InputError("bodies",
                     quoted(problem, (*overlap)[0]) + " and " + quoted(problem, (*overlap)[1]) +
                         " overlap, and no joint moves them against each other",
                     "ignore the pair, or write \"at_rest\": \"skip\"");
  const WayChecker checker(problem, space, options);
  require_free(problem, options, space, checker, problem.start, "start");
  if (const auto goal = Goal(problem, space).only(); goal && has_one_pose(problem.linkage))
    require_free(problem, options, space, checker, *goal, "goal");
  if (decide_translation(problem, options, space, checker, on_none.barrier, answer)) return;
  // There is no way, but that is to be proved otherwise.
  const bool blocked = std::exchange(answer.exact, false);
  PathSearch cells(problem, options, space, checker);
  try {
    cells.run(answer);
    if (blocked && answer.outcome != PathOutcome::none) {
      answer.reason = "exact signs show that there is no way, but no proof was found that the verifier accepts";
      answer.tight.reset();
    }
    if (on_none.cells && answer.outcome == PathOutcome::none) on_none.cells(space, cells.tree());
    if (options.shortest && answer.outcome == PathOutcome::path)
      shorten(problem, options, space, checker, cells.tree(), answer);
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
  }
  answer.cells = cells.cells(answer.outcome);
}

}  // namespace

PathAnswer find_path(const PathProblem& problem, const PathOptions& options) {
  return path::find_path(problem, options, {});
}

}  // namespace taut

namespace taut::internal::path {

PathAnswer find_path(const PathProblem& problem, const PathOptions& options, const OnNone& on_none) {
  validate_options(options);
  if (!problem.linkage.scene.clearances.empty())
    throw InputError("clearances", "a way keeps one clearance of all pairs", "take them out of the scene");
  const Budget scope(options.limits);
  PathAnswer answer;
  try {
    scope.check();
    validate(problem);
    search(problem, options, on_none, answer);
    return answer;
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
  }
  answer.coverage = coverage_before_search(problem.linkage.scene);
  return answer;
}

}  // namespace taut::internal::path
