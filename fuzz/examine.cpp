#include "examine.hpp"

#include <cctype>
#include <sstream>

#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "replan.hpp"
#include "scene/placement.hpp"
#include "support/audit.hpp"
#include "support/tiling_run.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"
#include "taut/simulation.hpp"
#include "tiling/root_faces.hpp"

namespace taut::fuzz {
using namespace internal;

const char* to_string(FindingKind kind) {
  const char* const names[] = {"none",        "rejected", "structure", "disagreement", "tiling", "proof",
                               "plan change", "query",    "undecided", "exception",    "crash",  "hang"};
  return names[static_cast<int>(kind)];
}

std::string Finding::signature() const {
  std::string s = std::string(to_string(kind)) + ": ";
  for (const char c : message.substr(0, message.find('\n'))) {
    const bool number = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!number) {
      s += c;
    } else if (s.back() != '#') {
      s += '#';
    }
  }
  return s;
}

std::string contradiction(const Answer& first, const Answer& second) {
  if (first.outcome == Outcome::undecided || second.outcome == Outcome::undecided) return {};
  if (first.outcome != second.outcome)
    return std::string(to_string(first.outcome)) + " against " + to_string(second.outcome);
  if (!first.contact) return {};
  const Contact &a = *first.contact, &b = *second.contact;
  if (a.time.hi < b.time.lo || b.time.hi < a.time.lo)
    return "contact within " + io::array_text({a.time.lo, a.time.hi}) + " against " +
           io::array_text({b.time.lo, b.time.hi});
  // At one instant, at the start or at a joint, bodies may touch in many places.
  if (a.time.lo == a.time.hi || b.time.lo == b.time.hi) return {};
  const bool same = a.vertex.body == b.vertex.body && a.vertex.index == b.vertex.index && a.edge.index == b.edge.index;
  return same ? std::string() : "contact of other features";
}

namespace {

std::string line(const char* touch, const Answer& a) {
  std::ostringstream s;
  s.precision(17);
  s << touch << ' ' << (a.compared ? "both" : to_string(a.engine)) << ": " << to_string(a.outcome);
  if (a.contact) {
    s << " t = [" << a.contact->time.lo << ", " << a.contact->time.hi << "] vertex " << a.contact->vertex.index
      << " of " << a.contact->vertex.body << " edge " << a.contact->edge.index;
  }
  s << " events " << a.events << " certificates " << a.certificates_max;
  if (!a.reason.empty()) s << " (" << a.reason << ')';
  return s.str();
}

/// The map against the static one, after every event.
std::string audit_tilings(const Scene& scene, const CheckOptions& options) {
  testing::AuditCounts counts;
  const Budget scope(Limits{options.limits.max_seconds});
  try {
    testing::TilingRun run(scene, options.touch);
    while (!run.finished() && run.engine().events() < options.max_events) {
      const std::string fault = testing::compare_with_static(run, counts);
      if (!fault.empty()) return fault;
      run.step(scene.end);
      scope.check();
    }
  } catch (const Undecidable&) {
  } catch (const Interrupted&) {
  }
  return {};
}

/// Of the kind of log that the engine in the options writes.
std::string audit_proof(const Scene& scene, const CheckOptions& options) {
  std::stringstream log;
  const Answer answer = prove(scene, log, options);
  if (answer.outcome == Outcome::overlap_at_start || (answer.outcome == Outcome::undecided && answer.events == 0))
    return {};
  // Verification sets itself no limits.
  const Budget scope(Limits{4 * options.limits.max_seconds});
  try {
    const Verified v = verify(scene, log);
    Answer proved;
    proved.outcome = v.outcome;
    proved.contact = v.contact;
    if (v.outcome != answer.outcome) return std::string("the log proves ") + to_string(v.outcome);
    return contradiction(answer, proved);
  } catch (const ProofError& e) {
    // Precision may end for the verifier where it did not for the engine.
    const std::string what = e.what();
    return what.find("precision") == std::string::npos ? what : std::string();
  } catch (const Interrupted&) {
    return {};
  }
}

/// The enclosure of the last event. The next one's may overlap it, and end before it.
class LastEvent : public Tracer {
 public:
  explicit LastEvent(double start) : lo(start) {}
  void on_event(const TraceEvent& event) override { lo = event.lo; }
  double lo;
};

/// What Simulation says between events, against itself.
std::string audit_query(Simulation& s, double before, const LastEvent& last) {
  if (s.time() < before) return "time goes back";
  const Tiling tiling = s.tiling();
  if (tiling.vertices.size() + tiling.faces.size() != tiling.edges.size() + 2) return "Euler's formula does not hold";
  if (s.active_set().size() != s.certificates()) return "active_set() and certificates() differ";
  const std::uint64_t events = s.events();
  const auto next = s.next_event();
  if (s.state() == SimulationState::undecided) return {};
  const double now = s.time();
  if (s.events() != events || now < before) return "next_event() makes events, or goes back";
  if (!next) return {};
  if (!(next->lo <= next->hi && last.lo <= next->hi)) return "the next event comes before the last one";
  const double middle = now + (next->lo - now) / 2;
  if (now < middle && middle < next->lo) {
    s.advance_to(middle);
    // The time that is set for all of these questions may be up by now.
    if (s.state() == SimulationState::undecided) return {};
    if (s.events() != events || s.time() != middle)
      return "advance_to() does not stand at a time before the next event";
  }
  return {};
}

std::string audit_queries(const Scene& scene, const Answer& answer, const CheckOptions& options) {
  const Budget scope(Limits{4 * options.limits.max_seconds});
  try {
    LastEvent last_event(scene.start);
    Simulation s(scene, options.touch, &last_event);
    double last = scene.start;
    while (s.state() == SimulationState::running) {
      if (s.events() >= options.max_events) return {};
      if (std::string fault = audit_query(s, last, last_event); !fault.empty()) return fault;
      last = s.time();
      scope.check();
      s.step();
    }
    if (s.state() == SimulationState::undecided) return {};
    Answer found;
    found.free_until = scene.start;
    found.contact = s.contact();
    found.outcome = s.state() == SimulationState::contact    ? Outcome::contact
                    : s.state() == SimulationState::finished ? Outcome::free
                                                             : Outcome::overlap_at_start;
    return contradiction(answer, found);
  } catch (const UndecidedError&) {
  } catch (const Interrupted&) {
  }
  return {};
}

/// Not for want of time or events.
bool is_beyond_precision(const Answer& answer) {
  return answer.outcome == Outcome::undecided && answer.reason.find("limit") == std::string::npos;
}

Finding look(const Scene& scene, Touch touch, const Evaluations& looks, std::string* report) {
  CheckOptions options;
  options.touch = touch;
  options.max_events = looks.max_events;
  options.limits.max_seconds = looks.max_seconds;
  options.engine = EngineChoice::both;
  const Answer answer = check(scene, options);
  if (report) *report += line(to_string(touch), answer) + '\n';
  if (looks.undecided && is_beyond_precision(answer)) return {FindingKind::undecided, answer.reason};
  options.engine = EngineChoice::kinetic;
  std::string fault;
  if (looks.tilings && !(fault = audit_tilings(scene, options)).empty()) return {FindingKind::tiling, fault};
  if (looks.proofs && !(fault = audit_proof(scene, options)).empty()) return {FindingKind::proof, fault};
  options.engine = EngineChoice::spacetime;
  if (looks.proofs && !(fault = audit_proof(scene, options)).empty()) return {FindingKind::proof, fault};
  options.engine = EngineChoice::kinetic;
  if (looks.queries && !(fault = audit_queries(scene, answer, options)).empty()) return {FindingKind::query, fault};
  if (looks.plan_changes && !(fault = audit_plan_changes(scene, answer, options)).empty())
    return {FindingKind::plan_change, fault};
  return {};
}

}  // namespace

Finding examine(const Scene& scene, const Evaluations& looks, std::string* report) {
  Finding found;
  try {
    for (const Touch touch : looks.touch) {
      found = look(scene, touch, looks, report);
      if (found.kind != FindingKind::none) break;
    }
  } catch (const InputError& e) {
    found = {FindingKind::rejected, e.what()};
  } catch (const EngineDisagreement& e) {
    if (report) *report += line("both", e.kinetic()) + '\n' + line("both", e.spacetime()) + '\n';
    found = {FindingKind::disagreement, e.what()};
  } catch (const StructureError& e) {
    found = {FindingKind::structure, e.what()};
  } catch (const std::exception& e) {
    found = {FindingKind::exception, e.what()};
  }
  if (report) *report += found.signature() + '\n';
  return found;
}

}  // namespace taut::fuzz
