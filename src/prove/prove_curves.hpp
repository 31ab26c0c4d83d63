// Proofs about scenes with curves: polygons around the bodies, and within them, and proofs about these.
#pragma once

#include <iosfwd>

#include "taut/check.hpp"
#include "taut/clearance.hpp"

namespace taut::internal {

/// Like prove(), for scenes with curves. Throws InputError.
Answer prove_curves(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Like prove_clearance(), for scenes with curves. Throws InputError.
MarginAnswer prove_clearance_of_curves(const Scene& scene, double clearance, std::ostream& log,
                                       const CheckOptions& options);

}  // namespace taut::internal
