// Determines whether bodies that stay free touch: the two readings of one scene.
#include <memory>

#include "check/run.hpp"
#include "taut/error.hpp"

namespace taut::internal {

bool leaves_touching_open(const Run& run, const CheckOptions& options) {
  if (run.answer().outcome != Outcome::free || options.touch != Touch::open || !options.tell_touching) return false;
  // For bodies that come closer than the displacement, doubles decide neither that they are disjoint nor that they
  // overlap.
  return run.stages().beyond_doubles() != 0;
}

Answer with_touching(const Run& run, const Scene& scene, const CheckOptions& options, const CheckFunction& again) {
  Answer answer = run.answer();
  if (!leaves_touching_open(run, options)) return answer;
  CheckOptions closed = options;
  closed.touch = Touch::closed;
  closed.tracer = nullptr;
  try {
    const Answer touching = again(scene, closed);
    answer.touching = touching.contact;
    answer.touching_undecided = touching.reason;
    answer.run_seconds += touching.build_seconds + touching.run_seconds;
  } catch (const InputError& refused) {
    // Features are too fine to be displaced outwards.
    answer.touching_undecided = refused.what();
  }
  return answer;
}

/// Many simultaneous events, as in drawings on a grid, require more than doubles. Yet most bodies with such events are
/// far from touching, or touch at once. Boxes show this quickly, whereas the tiling would have to be built again and
/// process all events.
CheckFunction unless_settled_early(std::uint64_t effort, const CheckFunction& otherwise) {
  return [effort, otherwise](const Scene& scene, const CheckOptions& options) {
    // The bodies are free with open touching.
    const std::unique_ptr<Run> boxes = begin_spacetime_apart(scene, options);
    if (boxes->work(effort)) {
      const Answer& decided = boxes->answer();
      if (decided.outcome == Outcome::free || (decided.contact && decided.contact->time.hi <= scene.start))
        return decided;
    }
    Answer answer = otherwise(scene, options);
    answer.run_seconds += boxes->answer().build_seconds + boxes->answer().run_seconds;
    return answer;
  };
}

}  // namespace taut::internal
