// What the user is told where the highest precision does not suffice.
#pragma once

#include <string>

#include "base/budget.hpp"
#include "base/errors.hpp"

namespace taut::internal {

/// The message for the user.
std::string not_decided(const Undecidable& limit);

/// Runs it. What stopped it before its end, precision or a limit; empty if nothing did.
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
