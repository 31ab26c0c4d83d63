// Writes down why bodies stay apart. Format: docs/proof-format.md.
#pragma once

#include <iosfwd>

#include "taut/check.hpp"

namespace taut {

/// By the spacetime engine, for any scene: first the answer, then the log, which is written when it is complete. An
/// answer for which no log was found is `undecided`. Throws InputError.
Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options);

/// The same where the answer is known already. What a contact is in the terms of a log is found anew, but that nothing
/// happens needs no engine.
Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options, const Answer& known);

}  // namespace taut
