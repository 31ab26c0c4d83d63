#include "solver/earliest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "solver/run.hpp"

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

// Compares the answers of two engines: one answer, or an exception.

namespace {

bool decided(const Answer& a) { return a.outcome != Outcome::undecided; }

bool apart(const TimeInterval& a, const TimeInterval& b) { return a.hi < b.lo || b.hi < a.lo; }

/// Describes the contradiction between two answers; null if there is none.
const char* contradiction(const Answer& kinetic, const Answer& spacetime) {
  for (const auto& [claim, other] : {std::pair(&kinetic, &spacetime), std::pair(&spacetime, &kinetic)}) {
    if (claim->outcome == Outcome::contact && claim->contact->time.hi < other->free_until)
      return "one engine finds a contact where the other one has proved the motion free";
  }
  if (!decided(kinetic) || !decided(spacetime)) return nullptr;
  if (kinetic.outcome != spacetime.outcome) return "the outcomes differ";
  if (kinetic.touching_undecided.empty() && spacetime.touching_undecided.empty() &&
      kinetic.touching.has_value() != spacetime.touching.has_value())
    return "one engine finds that bodies which stay free touch, the other one that they do not";
  if (!kinetic.contact) return nullptr;
  const Contact &a = *kinetic.contact, &b = *spacetime.contact;
  if (apart(a.time, b.time)) return "the times of contact differ";
  // Bodies that touch at the start may do so in many places. Later, the displacement admits only one first contact.
  if (a.time.lo == a.time.hi) return nullptr;
  if (a.vertex != b.vertex || a.edge != b.edge) return "the features in contact differ";
  return nullptr;
}

}  // namespace

}  // namespace taut::internal

namespace taut {
using namespace internal;

EngineDisagreement::EngineDisagreement(const std::string& what, const Answer& kinetic, const Answer& spacetime)
    : InternalError(what),
      kinetic_(std::make_shared<const Answer>(kinetic)),
      spacetime_(std::make_shared<const Answer>(spacetime)) {}

}  // namespace taut

namespace taut::internal {

Answer agreed(const Answer& kinetic, const Answer& spacetime) {
  if (const char* what = contradiction(kinetic, spacetime)) throw EngineDisagreement(what, kinetic, spacetime);
  Answer answer = decided(kinetic) || !decided(spacetime) ? kinetic : spacetime;
  answer.compared = decided(kinetic) && decided(spacetime);
  answer.events = kinetic.events;
  answer.certificates_initial = kinetic.certificates_initial;
  answer.certificates_max = kinetic.certificates_max;
  answer.free_until = std::max(kinetic.free_until, spacetime.free_until);
  if (kinetic.contact && spacetime.contact) {
    const TimeInterval &a = kinetic.contact->time, &b = spacetime.contact->time;
    answer.contact->time = {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  }
  answer.build_seconds = kinetic.build_seconds + spacetime.build_seconds;
  answer.run_seconds = kinetic.run_seconds + spacetime.run_seconds;
  return answer;
}

PairAnswer agreed_pair(const PairAnswer& kinetic, const PairAnswer& spacetime) {
  const auto alone = [](const PairAnswer& pair) {
    Answer answer;
    answer.outcome = pair.outcome;
    answer.contact = pair.contact;
    answer.free_until = pair.free_until;
    answer.reason = pair.reason;
    answer.pair = pair.bodies;
    return answer;
  };
  const Answer both = agreed(alone(kinetic), alone(spacetime));
  return {kinetic.bodies, both.outcome, both.contact, both.free_until, both.reason};
}

}  // namespace taut::internal
