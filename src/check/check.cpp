#include "taut/check.hpp"

#include "check/run.hpp"
#include "pair/validate_world.hpp"

namespace taut {

Answer check(const Scene& scene, const CheckOptions& options) {
  if (options.all_pairs || is_world(scene)) return run_world(scene, options);
  switch (options.engine) {
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
