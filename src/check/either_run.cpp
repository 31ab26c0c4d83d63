// Two engines in turn. Each is far ahead of the other on some motions, and nobody knows beforehand on which.
#include "check/run.hpp"

namespace taut {
namespace {

/// Of the first turn, in events; the next ones are twice as long each. In the time of an event, the other engine looks
/// at about so many pairs of boxes.
constexpr std::uint64_t first_effort = 1024, looks_per_event = 8;

bool decided(const Run& run) { return run.answer().outcome != Outcome::undecided; }

}  // namespace

Answer run_either(const Scene& scene, const CheckOptions& options) {
  const auto finished = [&](const Run& run) { return with_touching(run, scene, options, run_either); };
  const std::unique_ptr<Run> spacetime = begin_spacetime(scene, options);
  if (spacetime->work(first_effort * looks_per_event) && decided(*spacetime)) return finished(*spacetime);
  const std::unique_ptr<Run> kinetic = begin_kinetic(scene, options);
  for (std::uint64_t effort = first_effort;; effort *= 2) {
    const bool kinetic_done = kinetic->work(effort);
    if (kinetic_done && decided(*kinetic)) return finished(*kinetic);
    const bool spacetime_done = spacetime->work(2 * effort * looks_per_event);
    if (spacetime_done && decided(*spacetime)) return finished(*spacetime);
    if (!kinetic_done || !spacetime_done) continue;
    // Limits stopped both: what the one has proved free that went further.
    return kinetic->answer().free_until >= spacetime->answer().free_until ? kinetic->answer() : spacetime->answer();
  }
}

}  // namespace taut
