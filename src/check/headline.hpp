// From what happened to each pair to the answer about all of them.
#pragma once

#include <vector>

#include "search/pair_question.hpp"

namespace taut {

PairAnswer answer_of(const PairResult& result);

/// When something is known to have happened to the pair, or no more to be known.
double time_of(const PairAnswer& pair);

/// The outcome of all is that of the first pair, of those to which something happened.
void take_headline(const std::vector<PairAnswer>& events, Answer& answer);

}  // namespace taut
