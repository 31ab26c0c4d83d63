// What the inside throws, besides the errors of taut/error.hpp.
#pragma once

#include "taut/error.hpp"

namespace taut::internal {

/// The sign of a predicate could not be decided at the highest precision. Never turned into an answer, and never seen
/// outside: there it is an outcome, a state, or an UndecidedError.
struct Undecidable {
  const char* what;
};

}  // namespace taut::internal
