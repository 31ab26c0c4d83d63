// What stops a computation that no precision or no limit lets end, and the reason it gives the user.
#pragma once

#include <string>

#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {

/// The sign of a predicate could not be decided at the highest precision. It is never turned into an answer, and never
/// visible to users: for them it is an outcome, a state, or an UndecidedError.
struct Undecidable {
  const char* what;
};

// The message for the user where the highest precision does not suffice.

/// The message for the user.
std::string not_decided(const Undecidable& limit);

/// Runs the action. Returns the reason, precision or a limit, that stopped it before its end; empty if nothing did.
template <class Action>
std::string what_stops(const Action& action) {
  try {
    action();
  } catch (const Undecidable& limit) {
    return not_decided(limit);
  } catch (const Interrupted& limit) {
    return limit.reason;
  }
  return {};
}

}  // namespace taut::internal
