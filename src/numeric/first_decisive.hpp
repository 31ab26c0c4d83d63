// Evaluation at one precision after the other, until one decides.
//
// Cases that doubles leave open are evaluated at 320 bits first, because that nearly always decides and costs least.
// The result is "undecided" if the last precision does not decide. This loop exists only here.
#pragma once

#include <algorithm>
#include <optional>

#include "numeric/errors.hpp"
#include "numeric/root_isolation.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {

/// Calls ask(stage) from a stage on, usually the first at high precision, until the answer is not empty, or not zero.
/// Otherwise returns that empty answer.
template <class Ask>
auto first_decisive(const Ask& ask, Stage first = Stage::precise) -> decltype(ask(Stage::precise)) {
  for (Stage stage = first; stage <= last_stage; stage = next_precise(stage)) {
    if (auto answer = ask(stage)) return answer;
  }
  return {};
}

/// Like first_decisive(), where a decision is required; `what` is the question for the user.
template <class Ask>
auto decide(const char* what, const Ask& ask) -> decltype(ask(Stage::precise)) {
  auto answer = first_decisive(ask);
  if (!answer) throw Undecidable{what};
  return answer;
}

/// The sign of a ball given as a function of a number of its type; 0 if no stage decides.
template <class Quantity>
int decided_sign(const Quantity& quantity) {
  return first_decisive(
      [&](Stage stage) { return with_stage(stage, [&](auto zero) { return quantity(zero).sign(); }); });
}

/// Calls `ask(zero, stage)`, where a stage that cannot decide throws PrecisionExhausted; nothing if none can.
template <class Ask>
auto at_some_stage(const Ask& ask, Stage first = Stage::precise)
    -> std::optional<decltype(ask(Real320{}, Stage::precise))> {
  for (Stage stage = std::max(first, Stage::precise); stage <= last_stage; stage = next_precise(stage)) {
    try {
      return with_stage(stage, [&](auto zero) { return ask(zero, stage); });
    } catch (const PrecisionExhausted&) {
    }
  }
  return std::nullopt;
}

}  // namespace taut::internal
