// Exceptions thrown internally, besides the errors of taut/error.hpp.
#pragma once

#include "taut/error.hpp"

namespace taut::internal {

/// The sign of a predicate could not be decided at the highest precision. It is never turned into an answer, and never
/// visible to users: for them it is an outcome, a state, or an UndecidedError.
struct Undecidable {
  const char* what;
};

}  // namespace taut::internal
