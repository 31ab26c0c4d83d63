#include "taut/check.hpp"

#include <memory>

#include "base/budget.hpp"
#include "check/curved_questions.hpp"
#include "check/run.hpp"
#include "pair/fitted_scene.hpp"
#include "pair/validate_world.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut {
using namespace internal;

namespace {

/// Checks bodies that have been shrunk.
Answer check_fitted(const Scene& scene, CheckOptions options) {
  if (is_world(scene)) {
    validate_world(scene);
  } else {
    validate(scene);
  }
  const double fit = options.fit;
  options.fit = 0;
  const FittedScene fitted(scene, fit);
  Answer answer = check(fitted.scene(), options);
  fitted.name_given(answer);
  answer.fit = fit;
  return answer;
}

/// Checks by the tiling. Whether bodies that stay free touch is left to boxes if they decide early.
Answer check_by_tiling(const Scene& scene, const CheckOptions& options) {
  const std::uint64_t before = work_spent();
  const std::unique_ptr<Run> run = begin_kinetic(scene, options);
  run->work(UINT64_MAX);
  return with_touching(*run, scene, options,
                       unless_settled_early((work_spent() - before) / 2,
                                            [](const Scene& s, const CheckOptions& o) { return run_kinetic(s, o); }));
}

}  // namespace

Answer check(const Scene& scene, const CheckOptions& options) {
  if (!(options.time_tolerance >= 1e-15 && options.time_tolerance <= 1))
    throw InputError("time tolerance", "it is not between 1e-15 and 1", "1e-9 of the scene's time is usual");
  if (has_curves(scene)) return check_curved(scene, options);
  if (options.fit != 0) return check_fitted(scene, options);
  if (options.all_pairs || is_world(scene)) return run_world(scene, options);
  switch (engine_for_two(options)) {
    case EngineChoice::kinetic:
      return check_by_tiling(scene, options);
    case EngineChoice::spacetime:
      return run_spacetime(scene, options);
    case EngineChoice::either:
      return run_either(scene, options);
    default:
      return agreed(run_kinetic(scene, options), run_spacetime(scene, options));
  }
}

}  // namespace taut
