#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "base/interruption.hpp"
#include "check/run_watcher.hpp"
#include "numeric/undecided.hpp"
#include "pair/placement.hpp"

namespace taut {
namespace {

using Clock = std::chrono::steady_clock;

void conclude(const Session& session, Answer& answer) {
  const Engine& engine = session.engine();
  answer.events = engine.events();
  answer.certificates_initial = engine.initial_certificates();
  answer.certificates_max = engine.max_certificates();
  answer.free_until = std::clamp(answer.free_until, session.start(), session.end());
  if (session.overlap_at_start()) {
    answer.outcome = Outcome::overlap_at_start;
    answer.overlap_point = session.overlap_point();
    answer.free_until = session.start();
  } else if (session.contact()) {
    answer.outcome = Outcome::contact;
    answer.contact = session.contact();
    answer.free_until = answer.contact->time.lo;
  } else if (answer.reason.empty() && engine.state() == EngineState::finished) {
    answer.outcome = Outcome::free;
    answer.free_until = session.end();
  }
}

class KineticRun final : public Run {
 public:
  KineticRun(const Scene& scene, const CheckOptions& options, RunWatcher* watcher)
      : options_(options), watcher_(watcher), scope_(options.stop, options.max_seconds) {
    answer_.engine = EngineName::kinetic;
    answer_.free_until = scene.start;
    const Clock::time_point start = Clock::now();
    answer_.reason =
        what_stops([&] { session_ = std::make_unique<Session>(scene, options.touch, options.tracer, watcher); });
    if (!session_) return;
    answer_.build_seconds = seconds_since(start);
    if (watcher_) watcher_->started(*session_);
  }

  bool work(std::uint64_t effort) override {
    if (!session_ || done_) return true;
    const Clock::time_point start = Clock::now();
    done_ = run(effort);
    answer_.run_seconds += seconds_since(start);
    conclude(*session_, answer_);
    if (done_ && watcher_) watcher_->ended(*session_, answer_);
    return done_;
  }
  const Answer& answer() const override { return answer_; }
  StageCounts stages() const override { return session_ ? session_->engine().stages() : StageCounts(); }

 private:
  /// To the end, a contact, or a limit, of which the answer tells; or until the effort is spent.
  bool run(std::uint64_t effort) {
    const Engine& engine = session_->engine();
    const std::uint64_t begun = work_spent();
    try {
      while (!session_->finished()) {
        if (const std::string limit = limit_reached(); !limit.empty()) return give_up(limit, engine.proved_until());
        if (work_spent() - begun >= effort) return false;
        session_->step(session_->end());
      }
    } catch (const Interrupted& limit) {
      // In the middle of an event: what it left unfinished is not looked at.
      return give_up(limit.reason, engine.reached());
    } catch (const Undecidable& limit) {
      return give_up(not_decided(limit), engine.reached());
    }
    return true;
  }
  /// Between two events: what stops the run, or nothing.
  std::string limit_reached() const {
    const std::uint64_t events = session_->engine().events();
    if (events >= options_.max_events)
      return "the limit of " + std::to_string(options_.max_events) + " events was reached";
    if (events % 64 != 0) return {};
    try {
      scope_.check();
    } catch (const Interrupted& limit) {
      return limit.reason;
    }
    return {};
  }
  bool give_up(const std::string& reason, double free_until) {
    answer_.reason = reason;
    answer_.free_until = free_until;
    return true;
  }

  const CheckOptions& options_;
  RunWatcher* watcher_;
  InterruptionScope scope_;
  std::unique_ptr<Session> session_;
  Answer answer_;
  bool done_ = false;
};

}  // namespace

std::unique_ptr<Run> begin_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher* watcher) {
  return std::make_unique<KineticRun>(scene, options, watcher);
}

namespace {

Answer run(const Scene& scene, const CheckOptions& options, RunWatcher* watcher) {
  KineticRun run(scene, options, watcher);
  run.work(UINT64_MAX);
  return with_touching(run, scene, options, run_kinetic);
}

}  // namespace

Answer run_kinetic(const Scene& scene, const CheckOptions& options) { return run(scene, options, nullptr); }

Answer run_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher& watcher) {
  return run(scene, options, &watcher);
}

}  // namespace taut
