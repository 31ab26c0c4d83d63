// Compares the answers of two engines: one answer, or an exception.
#include <algorithm>
#include <cmath>

#include "solver/run.hpp"

namespace taut::internal {
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
