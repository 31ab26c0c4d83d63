#include "taut/check.hpp"

#include "check/curved_questions.hpp"
#include "check/run.hpp"
#include "pair/fitted_scene.hpp"
#include "pair/validate_world.hpp"
#include "taut/validate.hpp"

namespace taut {

namespace {

/// About bodies that have been shrunk.
Answer check_fitted(const Scene& scene, CheckOptions options) {
  if (is_world(scene)) {
    validate_world(scene);
  } else {
    validate(scene);
  }
  const double fit = options.fit;
  options.fit = 0;
  Answer answer = check(fitted(scene, fit), options);
  answer.fit = fit;
  return answer;
}

}  // namespace

Answer check(const Scene& scene, const CheckOptions& options) {
  if (has_curves(scene)) return check_curved(scene, options);
  if (options.fit != 0) return check_fitted(scene, options);
  if (options.all_pairs || is_world(scene)) return run_world(scene, options);
  switch (engine_for_two(options)) {
    case EngineChoice::kinetic:
      return run_kinetic(scene, options);
    case EngineChoice::spacetime:
      return run_spacetime(scene, options);
    case EngineChoice::either:
      return run_either(scene, options);
    default:
      return agreed(run_kinetic(scene, options), run_spacetime(scene, options));
  }
}

}  // namespace taut
