// Why a scene has no verdict.
#pragma once

#include <string>

#include "taut/coverage.hpp"

namespace taut::internal {

/// Of a coverage that is_empty(): that nothing was tested, why, and the remedy.
std::string why_untested(const Coverage& coverage);

}  // namespace taut::internal
