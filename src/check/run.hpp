// One engine, one answer.
#pragma once

#include "taut/check.hpp"

namespace taut {

/// By the kinetic data structure. Throws InputError.
Answer run_kinetic(const Scene& scene, const CheckOptions& options);

/// By bounding volumes over time. Throws InputError. It has no events, and no certificates.
Answer run_spacetime(const Scene& scene, const CheckOptions& options);

/// What both say. Throws EngineDisagreement.
Answer agreed(const Answer& kinetic, const Answer& spacetime);

}  // namespace taut
