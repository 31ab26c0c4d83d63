// One engine, one answer.
#pragma once

#include <chrono>

#include "taut/check.hpp"

namespace taut {

class RunWatcher;

/// By the kinetic data structure. The watcher may be null. Throws InputError.
Answer run_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher* watcher = nullptr);

/// By bounding volumes over time. Throws InputError. It has no events, and no certificates.
Answer run_spacetime(const Scene& scene, const CheckOptions& options);

/// What both say. Throws EngineDisagreement.
Answer agreed(const Answer& kinetic, const Answer& spacetime);

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace taut
