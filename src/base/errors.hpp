// Errors of the inside: none of them is ever turned into an answer.
#pragma once

#include <stdexcept>

namespace taut {

/// The sign of a predicate could not be decided at the highest precision.
struct Undecidable {
  const char* what;
};

/// An invariant of the structure does not hold: a bug, or input beyond what the rules cover.
struct StructureError : std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace taut
