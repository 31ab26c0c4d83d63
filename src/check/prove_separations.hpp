// Answers with logs of separations.
#pragma once

#include <iosfwd>

#include "taut/check.hpp"

namespace taut::internal {

/// Proves the answer by the spacetime engine, for any scene: first the answer, then the log, which is written when it
/// is complete. An answer for which no log was found is `undecided`. Throws InputError.
Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// Proves a known answer about two polygons: no engine has to find again that nothing happens, or nothing before a
/// contact.
Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options, const Answer& known);

}  // namespace taut::internal
