#include "support/exact_comparison.hpp"

#include <algorithm>
#include <sstream>

namespace taut::testing::exact {
namespace {

std::string both(const ExactAnswer& exact, const Answer& answer) {
  std::ostringstream s;
  s.precision(17);
  s << "exact: " << to_string(exact.verdict);
  if (exact.verdict == Verdict::contact) {
    s << " at " << exact.time.lo() << " multiplicity " << exact.multiplicity << " sway " << exact.sway;
  }
  s << ", answer: " << taut::to_string(answer.outcome);
  if (answer.contact) s << " in [" << answer.contact->time.lo << ", " << answer.contact->time.hi << "]";
  return s.str();
}

/// Is the exact time certainly more than `sway` before or after the interval?
bool apart(const ExactAnswer& exact, const TimeInterval& t) {
  const Wide sway(exact.sway);
  return (exact.time + sway).before(Wide(t.lo)) || Wide(t.hi).before(exact.time - sway);
}

bool among_meetings(const ExactAnswer& exact, const Contact& contact) {
  return std::any_of(exact.meetings.begin(), exact.meetings.end(), [&](const Meeting& m) {
    return m.vertex_body == contact.vertex.body && m.vertex == contact.vertex.index && m.edge == contact.edge.index;
  });
}

}  // namespace

std::string difference(const ExactAnswer& exact, const Answer& answer, const Scene& scene, Touch touch) {
  if (exact.verdict == Verdict::beyond || answer.outcome == Outcome::undecided) return {};
  const Wide end(scene.end);
  if (exact.verdict == Verdict::contact && answer.outcome == Outcome::free && touch == Touch::open) {
    // Smaller bodies touch later: perhaps after the end.
    return end.before(exact.time + Wide(exact.sway)) ? "" : "the outcome is wrong; " + both(exact, answer);
  }
  if (std::string(to_string(exact.verdict)) != taut::to_string(answer.outcome)) {
    return "the outcome is wrong; " + both(exact, answer);
  }
  if (!answer.contact) return {};
  if (apart(exact, answer.contact->time)) return "the time is wrong; " + both(exact, answer);
  if (!among_meetings(exact, *answer.contact)) return "the features do not meet; " + both(exact, answer);
  return {};
}

}  // namespace taut::testing::exact
