// Answers with logs of separations.
#pragma once

#include <iosfwd>

#include "solver/run.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// Proves the answer by the spacetime engine, for any scene: first the answer, then the log, which is written when it
/// is complete. An answer for which no log was found is `undecided`. Throws InputError.
Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Proves the answer of a run that has ended.
Answer prove_by_separations(const Run& run, const Scene& scene, std::ostream& log, const CheckOptions& options);

}  // namespace taut::internal
