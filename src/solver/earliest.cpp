#include "solver/earliest.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace taut::internal {

PairAnswer answer_of(const PairResult& result) {
  return {{result.a, result.b}, result.outcome, result.contact, result.free_until, result.reason};
}

PairAnswer answer_of(const PairResult& result, const Instance& instance) {
  PairAnswer answer = answer_of(result);
  answer.bodies = instance.scene_pair(result.a, result.b);
  return answer;
}

double time_of(const PairAnswer& pair) {
  return pair.outcome == Outcome::contact ? pair.contact->time.lo : pair.free_until;
}

namespace {

/// An overlap at the start comes before everything else. The rest is ordered by time.
bool before(const PairAnswer& a, const PairAnswer& b) {
  const bool overlap_a = a.outcome == Outcome::overlap_at_start, overlap_b = b.outcome == Outcome::overlap_at_start;
  if (overlap_a != overlap_b) return overlap_a;
  return time_of(a) < time_of(b);
}

/// The events that are unordered with the first one, itself included: every other overlap, or contacts that may come
/// before it.
std::vector<std::size_t> together(const std::vector<PairEvent>& events, const PairAnswer& first) {
  if (events.size() == 1) return {0};
  std::vector<std::size_t> alike;
  std::vector<ContactCandidate> contacts;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const PairAnswer& pair = events[i].pair;
    if (pair.outcome != first.outcome) continue;
    if (first.outcome == Outcome::undecided && &pair != &first) continue;
    alike.push_back(i);
    if (pair.contact) contacts.push_back({pair.contact->time, events[i].instant});
  }
  if (first.outcome != Outcome::contact) return alike;
  std::vector<std::size_t> chosen;
  for (const std::size_t k : possibly_first(contacts)) chosen.push_back(alike[k]);
  return chosen;
}

}  // namespace

std::vector<PairEvent> earliest_of_each_pair(std::vector<PairEvent> events) {
  if (events.size() < 2) return events;
  const auto happens = [](const PairEvent& event) { return event.pair.outcome != Outcome::free; };
  std::map<std::array<BodyId, 2>, std::vector<PairEvent>> by_pair;
  for (PairEvent& event : events) by_pair[event.pair.bodies].push_back(std::move(event));
  std::vector<PairEvent> first_ones;
  for (auto& [bodies, own] : by_pair) {
    if (std::any_of(own.begin(), own.end(), happens)) std::erase_if(own, std::not_fn(happens));
    if (own.size() == 1 || !happens(own.front())) {
      first_ones.push_back(std::move(own.front()));
      continue;
    }
    Answer all;
    take_earliest(own, all);
    // Which root it is does not matter: only contacts that no precision orders have several.
    const auto named = std::find_if(own.begin(), own.end(), [&](const PairEvent& event) {
      return event.pair.outcome == all.outcome && (!all.contact || event.pair.contact->vertex == all.contact->vertex);
    });
    first_ones.push_back({{bodies, all.outcome, all.contact, all.free_until, all.reason}, named->instant});
  }
  return first_ones;
}

void take_earliest(const std::vector<PairEvent>& events, Answer& answer) {
  if (events.empty()) return;
  const auto earlier = [](const PairEvent& a, const PairEvent& b) { return before(a.pair, b.pair); };
  const PairAnswer& first = std::min_element(events.begin(), events.end(), earlier)->pair;
  const std::vector<std::size_t> ties = together(events, first);
  const PairAnswer& named = events[ties.front()].pair;
  answer.outcome = named.outcome;
  answer.pair = named.bodies;
  answer.contact = named.contact;
  answer.reason = named.reason;
  answer.free_until = time_of(named);
  for (const std::size_t i : ties) answer.free_until = std::min(answer.free_until, time_of(events[i].pair));
  // The interval must contain the first contact of all, whichever that is.
  if (answer.contact) answer.contact->time.lo = answer.free_until;
  answer.also.clear();
  for (auto i = ties.begin() + 1; i != ties.end(); ++i) answer.also.push_back(events[*i].pair);
}

}  // namespace taut::internal
