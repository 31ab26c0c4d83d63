// The writers of the kinds of logs that prove() chooses from, besides that of tilings.
#pragma once

#include <iosfwd>

#include "solver/run.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"

namespace taut::internal {

/// Proves the answer by the spacetime engine, for any scene: first the answer, then the log, which is written when it
/// is complete. An answer for which no log was found is `undecided`. Throws InputError.
Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Proves the answer of a run that has ended.
Answer prove_by_separations(const Run& run, const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Like prove(), for scenes with curves. Throws InputError.
Answer prove_curves(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Like prove_clearance(), for scenes with curves. Throws InputError.
MarginAnswer prove_clearance_of_curves(const Scene& scene, double clearance, std::ostream& log,
                                       const CheckOptions& options);

}  // namespace taut::internal
