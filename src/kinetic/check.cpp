#include "taut/check.hpp"

#include <algorithm>
#include <chrono>
#include <memory>

#include "kinetic/session.hpp"
#include "motion/placement.hpp"

namespace taut {

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::free:
      return "free";
    case Outcome::contact:
      return "contact";
    case Outcome::overlap_at_start:
      return "overlap_at_start";
    default:
      return "undecided";
  }
}

const char* to_string(Touch touch) { return touch == Touch::open ? "open" : "closed"; }

const char* to_string(Repair repair) {
  switch (repair) {
    case Repair::convex_flip:
      return "convex_flip";
    case Repair::convex_triangle:
      return "convex_triangle";
    case Repair::reflex_new_face:
      return "reflex_a";
    case Repair::reflex_right:
      return "reflex_b";
    case Repair::reflex_left:
      return "reflex_c";
    default:
      return "collision";
  }
}

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Runs to the end, a contact, or a limit.
void run(Session& session, const CheckOptions& options, Clock::time_point start, Answer& answer) {
  const double end = session.scene().end;
  while (!session.finished()) {
    session.step(end);
    const std::uint64_t events = session.engine().events();
    if (session.finished()) return;
    if (events >= options.max_events) {
      answer.reason = "the limit of " + std::to_string(options.max_events) + " events was reached";
      return;
    }
    if (options.max_seconds < 1e299 && events % 64 == 0 && seconds_since(start) > options.max_seconds) {
      answer.reason = "the time limit was reached";
      return;
    }
  }
}

}  // namespace

Answer check(const Scene& scene, const CheckOptions& options) {
  Answer answer;
  answer.free_until = scene.start;
  const Clock::time_point start = Clock::now();
  std::unique_ptr<Session> session;
  try {
    session = std::make_unique<Session>(scene, options.touch, options.tracer);
    answer.build_seconds = seconds_since(start);
    const Clock::time_point built = Clock::now();
    run(*session, options, start, answer);
    answer.run_seconds = seconds_since(built);
  } catch (const Undecidable& limit) {
    answer.reason =
        std::string("not decided at ") + std::to_string(precision_ladder[precise_stages - 1]) + " bits: " + limit.what;
  }
  if (!session) return answer;
  const Engine& engine = session->engine();
  answer.events = engine.events();
  answer.certificates_initial = engine.initial_certificates();
  answer.certificates_max = engine.max_certificates();
  answer.free_until = std::max(scene.start, std::min(engine.time(), scene.end));
  if (session->overlap_at_start()) {
    answer.outcome = Outcome::overlap_at_start;
    answer.free_until = scene.start;
  } else if (session->contact()) {
    answer.outcome = Outcome::contact;
    answer.contact = session->contact();
    answer.free_until = answer.contact->time.lo;
  } else if (answer.reason.empty() && engine.state() == EngineState::finished) {
    answer.outcome = Outcome::free;
    answer.free_until = scene.end;
  }
  return answer;
}

}  // namespace taut
