#include "peers/verdict.hpp"

namespace taut::bench {
namespace {

/// Decides where one of the two says that the motion is free.
std::optional<Verdict> verdict_on_outcome(bool contact, bool hit) {
  if (contact && hit) return std::nullopt;
  if (contact) return Verdict::missed;
  return hit ? Verdict::false_alarm : Verdict::right;
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "right";
    case Verdict::early:
      return "early";
    case Verdict::late:
      return "late";
    case Verdict::missed:
      return "missed";
    case Verdict::false_alarm:
      return "false alarm";
  }
  return "?";
}

Verdict verdict_of_samples(const std::optional<TimeInterval>& contact, const std::vector<double>& times,
                           const std::optional<std::size_t>& hit) {
  if (const auto verdict = verdict_on_outcome(contact.has_value(), hit.has_value())) return *verdict;
  if (times.at(*hit) < contact->lo) return Verdict::early;
  // A sample at the contact itself sees bodies that only touch.
  return *hit > 0 && times[*hit - 1] > contact->hi ? Verdict::late : Verdict::right;
}

Verdict verdict_of_time(const std::optional<TimeInterval>& contact, const std::optional<double>& hit, double slack) {
  if (const auto verdict = verdict_on_outcome(contact.has_value(), hit.has_value())) return *verdict;
  if (*hit < contact->lo - slack) return Verdict::early;
  return *hit > contact->hi + slack ? Verdict::late : Verdict::right;
}

}  // namespace taut::bench
