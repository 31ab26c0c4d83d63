#include "check/headline.hpp"

#include <algorithm>

namespace taut {

PairAnswer answer_of(const PairResult& result) {
  return {{result.a, result.b}, result.outcome, result.contact, result.free_until, result.reason};
}

double time_of(const PairAnswer& pair) {
  return pair.outcome == Outcome::contact ? pair.contact->time.lo : pair.free_until;
}

namespace {

/// An overlap at the start comes before everything else; then what is first in time.
bool before(const PairAnswer& a, const PairAnswer& b) {
  const bool overlap_a = a.outcome == Outcome::overlap_at_start, overlap_b = b.outcome == Outcome::overlap_at_start;
  if (overlap_a != overlap_b) return overlap_a;
  return time_of(a) < time_of(b);
}

/// Contacts that enclosures do not tell apart are simultaneous, as far as is known.
bool together(const PairAnswer& a, const PairAnswer& b) {
  if (a.outcome != b.outcome) return false;
  return a.outcome == Outcome::overlap_at_start ||
         (a.outcome == Outcome::contact && a.contact->time.lo <= b.contact->time.hi &&
          b.contact->time.lo <= a.contact->time.hi);
}

}  // namespace

void take_headline(const std::vector<PairAnswer>& events, Answer& answer) {
  if (events.empty()) return;
  const PairAnswer& first = *std::min_element(events.begin(), events.end(), before);
  std::vector<PairAnswer> ties;
  for (const PairAnswer& pair : events) {
    if (&pair == &first || together(pair, first)) ties.push_back(pair);
  }
  const PairAnswer& named = ties.front();
  answer.outcome = named.outcome;
  answer.pair = named.bodies;
  answer.contact = named.contact;
  answer.reason = named.reason;
  answer.free_until = time_of(first);
  // The first of all is in it, whichever that is.
  if (answer.contact) answer.contact->time.lo = std::min(answer.contact->time.lo, first.contact->time.lo);
  answer.also.assign(ties.begin() + 1, ties.end());
}

}  // namespace taut
