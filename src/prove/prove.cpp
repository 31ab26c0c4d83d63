// Chooses the engine and the kind of log for an answer with a proof.
#include <sstream>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "prove/proof_writer.hpp"
#include "prove/separations_writer.hpp"
#include "scene/curved_world.hpp"
#include "scene/mechanism_lock.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"

namespace taut {
using namespace internal;
namespace {

/// The log is that of the engine which says more, and a tiling if both say the same. Which one it is becomes known at
/// the end, so the log of the tiling is kept until then.
Answer prove_by_both(const Scene& scene, std::ostream& log, const CheckOptions& options) {
  std::ostringstream tilings;
  const Answer by_tiling = prove_by_tiling(scene, tilings, options);
  CheckOptions boxes = options;
  boxes.engine = EngineChoice::spacetime;
  Run run(scene, boxes);
  run.run();
  Answer answer = agreed(by_tiling, run.answer_with_touching());
  const bool more = run.answer().outcome != Outcome::undecided || run.answer().free_until > by_tiling.free_until;
  if (by_tiling.outcome != Outcome::undecided || !more) {
    log << tilings.str();
    answer.contact = by_tiling.contact;
    answer.free_until = by_tiling.free_until;
    return answer;
  }
  const Answer proved = prove_by_separations(run, scene, log, boxes);
  if (proved.outcome == Outcome::undecided) return proved;
  answer.contact = proved.contact;
  answer.free_until = proved.free_until;
  return answer;
}

}  // namespace

namespace {

/// Of the scene's time, or that before a lock.
Answer prove_to_the_end(const Scene& scene, std::ostream& log, const CheckOptions& given) {
  CheckOptions options = given;
  options.all_pairs = false;
  if (options.fit != 0)
    throw InputError("fit", "a proof is about bodies as they are given",
                     "prove it without, or shrink the bodies yourself");
  // The engines, which run one after the other, and the writer of the log have limits of their own. This limit applies
  // to all of them together.
  const Budget scope(options.limits);
  if (has_curves(scene)) return prove_curves(scene, log, options);
  if (options.tracer) {
    validate_polygons(scene);
    require_ring_pair(scene, "a trace");
  }
  if (!is_ring_pair(scene)) return prove_by_separations(scene, log, options);
  switch (options.engine) {
    case EngineChoice::kinetic:
      return prove_by_tiling(scene, log, options);
    case EngineChoice::both:
      return prove_by_both(scene, log, options);
    default: {
      Run run(scene, options);
      run.run();
      return run.answer().engine == EngineName::kinetic ? prove_by_tiling(scene, log, options)
                                                        : prove_by_separations(run, scene, log, options);
    }
  }
}

}  // namespace

Answer prove(const Scene& scene, std::ostream& log, const CheckOptions& options) {
  Answer answer = prove_to_the_end(scene, log, options);
  note_lock(scene, answer.outcome, answer.reason);
  return answer;
}

}  // namespace taut
