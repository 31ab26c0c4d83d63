// What `taut path` and `taut prove` say about ways.
#pragma once

#include <string>

#include "taut/path.hpp"

namespace taut::cli {

/// The answer for a person.
std::string path_in_words(const PathProblem& problem, const PathAnswer& answer);
/// 0 a way, 1 none, 3 undecided, 2 untested.
int exit_code(PathOutcome outcome, bool allow_untested);

}  // namespace taut::cli
