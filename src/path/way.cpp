#include "path/way.hpp"

#include <algorithm>

#include "taut/clearance.hpp"

namespace taut::internal::path {

WayChecker::WayChecker(const PathProblem& problem, const JointSpace& space, const PathOptions& options)
    : problem_(problem), space_(space), options_(options) {}

/// Pairs that no joint moves against each other are no part of the question, but for those that were tested; all others
/// are tested, also if nothing moves them on this way.
Scene WayChecker::scene_of(const std::vector<JointValues>& way) const {
  Scene scene = scene_along(problem_, way);
  ignore_pairs(scene, space_.pairs().fixed());
  scene.at_rest = AtRest::test;
  return scene;
}

CheckOptions WayChecker::check_options() const {
  CheckOptions options;
  options.touch = options_.clearance > 0 ? Touch::open : options_.touch;
  options.tell_touching = false;
  options.limits = options_.limits;
  return options;
}

std::optional<StillCollision> WayChecker::collision_at(const JointValues& values) const {
  const Scene scene = scene_of({values});
  const CheckOptions options = check_options();
  if (options_.clearance > 0) {
    const MarginAnswer answer = check_clearance(scene, options_.clearance, options);
    if (answer.outcome == Outcome::free) return std::nullopt;
    StillCollision found{{}, answer.outcome == Outcome::undecided, answer.reason};
    if (answer.first) found.pair = answer.first->bodies;
    return found;
  }
  const Answer answer = check(scene, options);
  if (answer.outcome == Outcome::free) return std::nullopt;
  return StillCollision{answer.pair, answer.outcome == Outcome::undecided, answer.reason};
}

bool WayChecker::proves(const std::vector<JointValues>& way) const {
  const Scene scene = scene_of(way);
  const CheckOptions options = check_options();
  if (options_.clearance > 0) {
    return check_clearance(scene, options_.clearance, options).outcome == Outcome::free;
  }
  return check(scene, options).outcome == Outcome::free;
}

bool WayChecker::passes(const JointValues& a, const JointValues& b, bool exactly) const {
  return space_.is_free(a, b) || (exactly && proves({a, b}));
}

std::vector<JointValues> WayChecker::shortened(const std::vector<JointValues>& way) const {
  std::vector<JointValues> kept = {way.front()};
  for (std::size_t i = 0; i + 1 < way.size();) {
    // By bisection, as if what passes farther passed nearer as well.
    std::size_t next = i + 1;
    for (std::size_t step = way.size(); step > 0; step /= 2) {
      const std::size_t tried = std::min(next + step, way.size() - 1);
      if (tried > next && passes(way[i], way[tried], false)) next = tried;
    }
    kept.push_back(way[next]);
    i = next;
  }
  return kept;
}

}  // namespace taut::internal::path
