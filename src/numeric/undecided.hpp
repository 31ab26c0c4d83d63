// The message for the user where the highest precision does not suffice.
#pragma once

#include <string>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"

namespace taut::internal {

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
