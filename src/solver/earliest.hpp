// Combines the results of all pairs into one answer.
#pragma once

#include <optional>
#include <vector>

#include "solver/pair_solver.hpp"

namespace taut::internal {

PairAnswer answer_of(const PairResult& result);
/// In the numbers of the scene's bodies.
PairAnswer answer_of(const PairResult& result, const Instance& instance);

/// The result for a pair, and its contact as a root.
struct PairEvent {
  PairAnswer pair;
  std::optional<ContactInstant> instant;
};

/// The time of the event of the pair, or up to which it is known.
double time_of(const PairAnswer& pair);

/// Of each two bodies of the scene one event, the first: bodies with several cross-sections may have several.
std::vector<PairEvent> earliest_of_each_pair(std::vector<PairEvent> events);

/// The outcome of all pairs is that of the first pair that is not free. If the highest precision does not decide the
/// order of contacts, the first of them in the order of the scene is named, and the others are listed with it.
void take_earliest(const std::vector<PairEvent>& events, Answer& answer);

}  // namespace taut::internal
