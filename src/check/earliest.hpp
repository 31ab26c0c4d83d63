// From what happened to each pair to the answer about all of them.
#pragma once

#include <optional>
#include <vector>

#include "search/pair_solver.hpp"

namespace taut::internal {

PairAnswer answer_of(const PairResult& result);

/// What happened to a pair, and what a contact is the root of.
struct PairEvent {
  PairAnswer pair;
  std::optional<ContactInstant> instant;
};

/// When something is known to have happened to the pair, or no more to be known.
double time_of(const PairAnswer& pair);

/// The outcome of all is that of the first pair, of those to which something happened. Where the order of contacts is
/// not told by the highest precision, the first of them in the order of the scene is named, and the others come along.
void take_earliest(const std::vector<PairEvent>& events, Answer& answer);

}  // namespace taut::internal
