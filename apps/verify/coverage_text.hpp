// Which pairs an answer is about, in words.
#pragma once

#include <string>

#include "taut/coverage.hpp"

namespace taut::cli {

/// A line that counts the pairs, and says of which of them nothing was tested. Empty if there is one pair and it was
/// tested. Reports have it as their second line.
std::string coverage_text(const Coverage& coverage);

}  // namespace taut::cli
