// Pairs that were not tested, and why.
#pragma once

#include <string>

#include "taut/coverage.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Of a coverage that is_empty(): that nothing was tested, why, and the remedy.
std::string why_untested(const Coverage& coverage);

/// For the title of a picture: "; 2 pairs not tested", "; nothing was tested", or nothing if all pairs were tested.
std::string untested_note(const Coverage& coverage);

/// The coverage of an answer whose search was stopped before bodies were prepared: no pair was reached. Ignored pairs
/// are counted as such. Throws InputError if the scene ignores bodies that do not exist.
Coverage coverage_before_search(const Scene& scene);

/// The coverage of an answer whose search was stopped after so many pairs: all others that the question is about were
/// not reached.
Coverage coverage_when_stopped(Coverage coverage, std::uint64_t tested);

}  // namespace taut::internal
