// The run of an engine, and its answer.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

#include "numeric/stages.hpp"
#include "taut/check.hpp"

namespace taut::internal {

class NearStart;
class RunWatcher;

/// An engine that works on a query. It can be interrupted and resumed. Runs must end in the reverse order of their
/// beginning.
class Run {
 public:
  virtual ~Run() = default;
  /// Continues for about this much work, in the units of checkpoint(). Returns true once answer() is final. If a limit
  /// of the options, or the precision, stopped the run, the answer is `undecided`.
  virtual bool work(std::uint64_t effort) = 0;
  virtual const Answer& answer() const = 0;
  /// If no stage beyond doubles decided anything, both readings of touching have the same answer.
  virtual StageCounts stages() const = 0;
};

/// Called at the beginning, in a scene of two bodies: their pair is the one that is tested.
inline void speak_of_two(Answer& answer) {
  answer.pair = {0, 1};
  answer.coverage.pairs = answer.coverage.tested = 1;
}

/// Nothing happens until `end`, the end of the scene's time.
inline void conclude_free(double end, Answer& answer) {
  answer.outcome = Outcome::free;
  answer.free_until = end;
  answer.pair.reset();
}

/// The scene and the options must outlive the run. Throws InputError.
std::unique_ptr<Run> begin_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher* watcher = nullptr);
std::unique_ptr<Run> begin_spacetime(const Scene& scene, const CheckOptions& options);
/// For bodies that are known not to overlap at the start.
std::unique_ptr<Run> begin_spacetime_apart(const Scene& scene, const CheckOptions& options);

/// Uses only the kinetic data structure. Throws InputError.
Answer run_kinetic(const Scene& scene, const CheckOptions& options);
/// Like run_kinetic(), with an observer.
Answer run_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher& watcher);

/// The same answer, started near the start of the last query where that is worthwhile.
struct NearAnswer {
  Answer answer;
  bool began_near = false;
};
NearAnswer run_kinetic(const Scene& scene, const CheckOptions& options, NearStart& near);

/// Uses bounding volumes over time. Throws InputError. It has no events and no certificates.
Answer run_spacetime(const Scene& scene, const CheckOptions& options);

/// The engine for a query about two polygons. `usual` means either, but a limit of events implies the engine that has
/// events. A tracer changes no answer, and therefore not the engine.
inline EngineChoice engine_for_two(const CheckOptions& options) {
  if (options.engine != EngineChoice::usual) return options.engine;
  return options.max_events == UINT64_MAX ? EngineChoice::either : EngineChoice::kinetic;
}

/// Uses the engine that is done first, with both in alternating slices of increasing length. Throws InputError.
Answer run_either(const Scene& scene, const CheckOptions& options);

/// The answer of a completed run, for open touching. If it is `free` due to the displacement, `again` is called with
/// closed touching: see Answer::touching.
using CheckFunction = std::function<Answer(const Scene&, const CheckOptions&)>;
Answer with_touching(const Run& run, const Scene& scene, const CheckOptions& options, const CheckFunction& again);
/// A function for with_touching(), whose bodies are known to be free. It calls `otherwise`, unless boxes show with this
/// little work that nothing meets, or at once that the bodies touch from the start.
CheckFunction unless_settled_early(std::uint64_t effort, const CheckFunction& otherwise);
/// Is a second query about touching required?
bool leaves_touching_open(const Run& run, const CheckOptions& options);

/// For a scene that is not two bodies of one polygon each. Throws InputError.
Answer run_world(const Scene& scene, const CheckOptions& options);

/// The common answer of both engines. Throws EngineDisagreement.
Answer agreed(const Answer& kinetic, const Answer& spacetime);
/// The common answer for one pair of a world.
PairAnswer agreed_pair(const PairAnswer& kinetic, const PairAnswer& spacetime);

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace taut::internal
