// Chooses the engine and the kind of log for an answer with a proof.
#include "base/budget.hpp"
#include "base/errors.hpp"
#include "check/proof_writer.hpp"
#include "check/prove_curves.hpp"
#include "check/prove_separations.hpp"
#include "pair/curved_world.hpp"
#include "pair/validate_world.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"

namespace taut {
using namespace internal;

Answer prove(const Scene& scene, std::ostream& log, const CheckOptions& options) {
  if (options.fit != 0)
    throw InputError("fit", "a proof is about bodies as they are given",
                     "prove it without, or shrink the bodies yourself");
  // The engines, which run one after the other, and the writer of the log have limits of their own. This limit applies
  // to all of them together.
  const Budget scope(options.limits);
  if (has_curves(scene)) return prove_curves(scene, log, options);
  if (is_world(scene)) return prove_by_separations(scene, log, options);
  switch (engine_for_two(options)) {
    case EngineChoice::kinetic:
      return prove_by_tiling(scene, log, options);
    case EngineChoice::spacetime:
      return prove_by_separations(scene, log, options);
    case EngineChoice::either: {
      const Answer first = run_either(scene, options);
      return first.engine == EngineName::kinetic ? prove_by_tiling(scene, log, options)
                                                 : prove_by_separations(scene, log, options, first);
    }
    default:
      return agreed(prove_by_tiling(scene, log, options), run_spacetime(scene, options));
  }
}

}  // namespace taut
