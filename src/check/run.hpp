// One engine, one answer.
#pragma once

#include "taut/check.hpp"

namespace taut {

class RunWatcher;

/// By the kinetic data structure. The watcher may be null. Throws InputError.
Answer run_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher* watcher = nullptr);

/// By bounding volumes over time. Throws InputError. It has no events, and no certificates.
Answer run_spacetime(const Scene& scene, const CheckOptions& options);

/// What both say. Throws EngineDisagreement.
Answer agreed(const Answer& kinetic, const Answer& spacetime);

}  // namespace taut
