// The run of the engines for the first contact of any pair, and its answer.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numeric/budget.hpp"
#include "solver/earliest.hpp"
#include "solver/world_search.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// The search for the first contact of any pair of a scene without curves, and its result.
class Run {
 public:
  /// The observer is notified of the kinetic engine's events; it may be null. The arguments must outlive the run.
  Run(const Scene& scene, const CheckOptions& options, KineticObserver* observer = nullptr);

  /// Runs to the end, to the first contact, or to a limit. Throws InputError.
  void run();
  const Answer& answer() const { return answer_; }
  /// The answer, including for open touching whether bodies that stay free touch: see Answer::touching.
  Answer answer_with_touching() const;
  /// None if the run was interrupted before there was one.
  const std::optional<Instance>& instance() const { return instance_; }
  const std::optional<WorldSearch>& search() const { return search_; }

 private:
  void prepare();
  void leave_untested();
  void conclude();
  void conclude_coverage(std::uint64_t tested);
  std::vector<PairEvent> pairs() const;
  void name_engine();
  bool leaves_touching_open() const;

  const Scene& scene_;
  const CheckOptions& options_;
  SolverChoice choice_;
  Budget scope_;
  std::optional<Instance> instance_;
  std::optional<WorldSearch> search_;
  Answer answer_;
  std::string stopped_;
  std::uint64_t work_ = 0;  ///< of run(), in units of checkpoint()
};

/// Checks a scene without curves whose bodies are not to be shrunk. Throws InputError.
Answer run_engines(const Scene& scene, const CheckOptions& options);

/// The common answer of both engines. Throws EngineDisagreement.
Answer agreed(const Answer& kinetic, const Answer& spacetime);
/// The common answer for one pair.
PairAnswer agreed_pair(const PairAnswer& kinetic, const PairAnswer& spacetime);

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What is left of a limit in seconds that began then: never less than 0.
inline double time_left(double seconds, std::chrono::steady_clock::time_point began) {
  return std::max(0.0, seconds - seconds_since(began));
}

}  // namespace taut::internal
