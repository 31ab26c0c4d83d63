#include "taut/check.hpp"
#include "query/bracket.hpp"
#include "scene/fitted_scene.hpp"
#include "scene/mechanism_lock.hpp"
#include "scene/validate_scene.hpp"
#include "solver/run.hpp"
#include "taut/error.hpp"

namespace taut {

using namespace internal;

namespace {

/// Checks bodies that have been shrunk.
Answer check_fitted(const Scene& scene, CheckOptions options) {
  validate_polygons(scene);
  const double fit = options.fit;
  options.fit = 0;
  const FittedScene fitted(scene, fit);
  Answer answer = check(fitted.scene(), options);
  fitted.name_given(answer);
  answer.fit = fit;
  return answer;
}

}  // namespace

Answer check(const Scene& scene, const CheckOptions& options) {
  if (!(options.time_tolerance >= 1e-15 && options.time_tolerance <= 1))
    throw InputError("time tolerance", "it is not between 1e-15 and 1", "1e-9 of the scene's time is usual");
  Answer answer = has_curves(scene)  ? check_curved(scene, options)
                  : options.fit != 0 ? check_fitted(scene, options)
                                     : run_engines(scene, options);
  note_lock(scene, answer.outcome, answer.reason);
  return answer;
}

}  // namespace taut

namespace taut::internal {

// The scene of two bodies and all their parents.

Scene scene_of_pair(const Scene& scene, const std::array<BodyId, 2>& pair, std::vector<BodyId>& ids) {
  std::vector<bool> kept(scene.bodies.size(), false);
  const auto keep = [&](BodyId id) {
    for (bool found = true; found;) {
      found = false;
      kept[static_cast<std::size_t>(id)] = true;
      const std::string& parent = scene.bodies[static_cast<std::size_t>(id)].relative_to;
      for (std::size_t k = 0; k < scene.bodies.size() && !found && !parent.empty(); ++k) {
        found = scene.bodies[k].name == parent && !kept[k];
        if (found) id = static_cast<BodyId>(k);
      }
    }
  };
  keep(pair[0]);
  keep(pair[1]);
  Scene small;
  small.start = scene.start;
  small.end = scene.end;
  small.at_rest = AtRest::test;  // the pair may be one at rest
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (!kept[k]) continue;
    ids.push_back(static_cast<BodyId>(k));
    small.bodies.push_back(scene.bodies[k]);
    if (ids.back() != pair[0] && ids.back() != pair[1]) small.ignore.push_back({scene.bodies[k].name, "*"});
  }
  return small;
}

}  // namespace taut::internal
