// One engine, one answer.
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

/// An engine at work on a question. It can be left and taken up again; runs must end in the reverse of the order in
/// which they began.
class Run {
 public:
  virtual ~Run() = default;
  /// Goes on for about so much work, in the units of checkpoint(); true once answer() says all that will come
  /// of it.
  /// What a limit of the options stopped, or precision, is `undecided`.
  virtual bool work(std::uint64_t effort) = 0;
  virtual const Answer& answer() const = 0;
  /// Where none told beyond doubles, both readings of touching have the same answer.
  virtual StageCounts stages() const = 0;
};

/// At the beginning, in a scene of two bodies: their pair is the one that is tested.
inline void speak_of_two(Answer& answer) {
  answer.pair = {0, 1};
  answer.coverage.pairs = answer.coverage.tested = 1;
}

/// Nothing happens until then, the end of the scene's time.
inline void conclude_free(double end, Answer& answer) {
  answer.outcome = Outcome::free;
  answer.free_until = end;
  answer.pair.reset();
}

/// The scene and the options must live as long as the run. Throw InputError.
std::unique_ptr<Run> begin_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher* watcher = nullptr);
std::unique_ptr<Run> begin_spacetime(const Scene& scene, const CheckOptions& options);
/// Of bodies that are known not to overlap at the start.
std::unique_ptr<Run> begin_spacetime_apart(const Scene& scene, const CheckOptions& options);

/// By the kinetic data structure and nothing else. Throws InputError.
Answer run_kinetic(const Scene& scene, const CheckOptions& options);
/// The same, watched.
Answer run_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher& watcher);

/// The same answer, begun near the last question's start where that is worth it.
struct NearAnswer {
  Answer answer;
  bool began_near = false;
};
NearAnswer run_kinetic(const Scene& scene, const CheckOptions& options, NearStart& near);

/// By bounding volumes over time. Throws InputError. It has no events, and no certificates.
Answer run_spacetime(const Scene& scene, const CheckOptions& options);

/// Whom a question about two polygons is put to: `usual` is either, but who limits events means the engine that has
/// some. A tracer changes no answer, and so not who is asked.
inline EngineChoice engine_for_two(const CheckOptions& options) {
  if (options.engine != EngineChoice::usual) return options.engine;
  return options.max_events == UINT64_MAX ? EngineChoice::either : EngineChoice::kinetic;
}

/// By whichever is done first, where both work in turn, for longer and longer. Throws InputError.
Answer run_either(const Scene& scene, const CheckOptions& options);

/// The answer of a run that is done, for open touching. Where it is `free` by the displacement, `again` is asked with
/// closed touching: see Answer::touching.
using CheckFunction = std::function<Answer(const Scene&, const CheckOptions&)>;
Answer with_touching(const Run& run, const Scene& scene, const CheckOptions& options, const CheckFunction& again);
/// For with_touching(), whose bodies are known to be free: asks `otherwise`, unless boxes show with so little work that
/// nothing meets, or at once that the bodies rest on each other from the start.
CheckFunction unless_settled_early(std::uint64_t effort, const CheckFunction& otherwise);
/// Will it be asked again?
bool leaves_touching_open(const Run& run, const CheckOptions& options);

/// Of a scene that is not two bodies of one polygon each. Throws InputError.
Answer run_world(const Scene& scene, const CheckOptions& options);

/// What both say. Throws EngineDisagreement.
Answer agreed(const Answer& kinetic, const Answer& spacetime);
/// The same of one pair of a world.
PairAnswer agreed_pair(const PairAnswer& kinetic, const PairAnswer& spacetime);

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace taut::internal
