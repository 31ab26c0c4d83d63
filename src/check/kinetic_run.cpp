#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "check/run_watcher.hpp"
#include "motion/placement.hpp"
#include "numeric/interruption.hpp"

namespace taut {
namespace {

using Clock = std::chrono::steady_clock;

/// Runs to the end, a contact, or a limit; says which limit.
std::string run(Session& session, const CheckOptions& options, const InterruptionScope& scope, Answer& answer) {
  const double end = session.scene().end;
  try {
    while (!session.finished()) {
      const std::uint64_t events = session.engine().events();
      if (events >= options.max_events) {
        answer.free_until = session.engine().proved_until();
        return "the limit of " + std::to_string(options.max_events) + " events was reached";
      }
      if (events % 64 == 0) {
        try {
          scope.check();
        } catch (const Interrupted& limit) {
          answer.free_until = session.engine().proved_until();
          return limit.reason;
        }
      }
      session.step(end);
    }
  } catch (const Interrupted& limit) {
    // In the middle of an event: what it left unfinished is not looked at.
    answer.free_until = session.engine().reached();
    return limit.reason;
  } catch (const Undecidable& limit) {
    answer.free_until = session.engine().reached();
    return not_decided(limit);
  }
  return {};
}

void conclude(const Session& session, Answer& answer) {
  const Engine& engine = session.engine();
  const Scene& scene = session.scene();
  answer.events = engine.events();
  answer.certificates_initial = engine.initial_certificates();
  answer.certificates_max = engine.max_certificates();
  answer.free_until = std::clamp(answer.free_until, scene.start, scene.end);
  if (session.overlap_at_start()) {
    answer.outcome = Outcome::overlap_at_start;
    answer.free_until = scene.start;
  } else if (session.contact()) {
    answer.outcome = Outcome::contact;
    answer.contact = session.contact();
    answer.free_until = answer.contact->time.lo;
  } else if (answer.reason.empty() && engine.state() == EngineState::finished) {
    answer.outcome = Outcome::free;
    answer.free_until = scene.end;
  }
}

}  // namespace

Answer run_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher* watcher) {
  Answer answer;
  answer.engine = EngineChoice::kinetic;
  answer.free_until = scene.start;
  const InterruptionScope scope(options.stop, options.max_seconds);
  const Clock::time_point start = Clock::now();
  std::unique_ptr<Session> session;
  try {
    session = std::make_unique<Session>(scene, options.touch, options.tracer, watcher);
  } catch (const Undecidable& limit) {
    answer.reason = not_decided(limit);
    return answer;
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
    return answer;
  }
  answer.build_seconds = seconds_since(start);
  if (watcher) watcher->started(*session);
  const Clock::time_point built = Clock::now();
  answer.reason = run(*session, options, scope, answer);
  answer.run_seconds = seconds_since(built);
  conclude(*session, answer);
  if (watcher) watcher->ended(*session, answer);
  return answer;
}

}  // namespace taut
