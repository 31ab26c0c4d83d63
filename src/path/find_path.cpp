// The question: is there any way?
#include "path/find_path.hpp"

#include <cmath>

#include "numeric/budget.hpp"
#include "path/path_search.hpp"
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

/// Throws InputError where bodies collide at what the problem states; nothing if the engines do not decide that.
void require_free(const PathProblem& problem, const PathOptions& options, const WayChecker& checker,
                  const JointValues& values, const char* where) {
  const std::optional<StillCollision> found = checker.collision_at(values);
  if (!found || found->undecided || !found->pair) return;
  throw InputError(where, collision_text(problem, options, *found), "give joint values at which no bodies collide");
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
  require_free(problem, options, checker, problem.start, "start");
  if (const auto goal = Goal(problem, space).only()) require_free(problem, options, checker, *goal, "goal");
  if (decide_translation(problem, options, space, checker, answer)) {
    if (!on_none || answer.outcome != PathOutcome::none) return;
    // The same again by cells.
    answer.outcome = PathOutcome::undecided;
    answer.exact = false;
  }
  PathSearch cells(problem, options, space, checker);
  try {
    cells.run(answer);
    if (on_none && answer.outcome == PathOutcome::none) on_none(space, cells.tree());
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
  }
  answer.cells = cells.cells();
}

}  // namespace

PathAnswer find_path(const PathProblem& problem, const PathOptions& options) {
  return path::find_path(problem, options, {});
}

}  // namespace taut

namespace taut::internal::path {

PathAnswer find_path(const PathProblem& problem, const PathOptions& options, const OnNone& on_none) {
  validate_options(options);
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
