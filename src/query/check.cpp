#include "taut/check.hpp"

#include "query/curved_questions.hpp"
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
