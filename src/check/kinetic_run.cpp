// A run of the kinetic engine that can be interrupted and resumed.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "base/budget.hpp"
#include "base/progress.hpp"
#include "check/run_watcher.hpp"
#include "numeric/undecided.hpp"
#include "pair/placement.hpp"

namespace taut::internal {
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
    conclude_free(session.end(), answer);
  }
}

/// Adds the duration of its lifetime.
class Timer {
 public:
  explicit Timer(double& seconds) : seconds_(seconds), start_(Clock::now()) {}
  ~Timer() { seconds_ += seconds_since(start_); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  double& seconds_;
  Clock::time_point start_;
};

/// A slice that ends in the middle of an event is resumed there: the engine keeps the completed work, and the current
/// search for a sign change. An event that has begun may take as much additional work as the slice, or its predicted
/// work if that is more; the prediction is rough. Lost work is repeated only in a slice of at least twice that work. An
/// operation that cannot be interrupted is not begun before there is room for it.
class KineticRun final : public Run {
 public:
  KineticRun(const Scene& scene, const CheckOptions& options, RunWatcher* watcher, NearStart* near = nullptr)
      : scene_(scene), options_(options), watcher_(watcher), near_(near), scope_(options.limits) {
    answer_.engine = EngineName::kinetic;
    answer_.free_until = scene.start;
    speak_of_two(answer_);
  }

  bool work(std::uint64_t effort) override {
    if (done_) return true;
    if (effort < needed_) return false;
    needed_ = 0;
    const Budget turn(effort, std::max({effort, wanted_, std::uint64_t{64}}));
    const std::uint64_t until = effort < UINT64_MAX - work_spent() ? work_spent() + effort : UINT64_MAX;
    step_began_ = work_spent();
    try {
      if (!session_) build();
      done_ = run(until);
    } catch (const Interrupted& limit) {
      if (!turn.exhausted()) give_up(limit.reason, reached());
      needed_ = std::max(2 * lost(turn), turn.wanted());
      wanted_ = turn.wanted();
    } catch (const Undecidable& limit) {
      give_up(not_decided(limit), reached());
    }
    if (!session_) return done_;
    conclude(*session_, answer_);
    if (done_ && watcher_) watcher_->ended(*session_, answer_);
    return done_;
  }
  const Answer& answer() const override { return answer_; }
  bool began_near() const { return session_ && session_->began_near(); }
  StageCounts stages() const override { return session_ ? session_->engine().stages() : StageCounts(); }

 private:
  /// The lost work that has to be repeated.
  std::uint64_t lost(const Budget& turn) const {
    const std::uint64_t since = std::max(step_began_, session_ ? session_->engine().work_kept() : 0);
    return work_spent() - std::min(work_spent(), since + turn.kept());
  }

  void build() {
    const Timer timer(answer_.build_seconds);
    session_ = std::make_unique<Session>(scene_, options_.touch, options_.tracer, watcher_, near_);
    if (watcher_) watcher_->started(*session_);
  }
  /// Runs to the end, to a contact, or to a limit, which the answer names; or until this much work is spent.
  bool run(std::uint64_t until) {
    const Timer timer(answer_.run_seconds);
    while (!session_->finished()) {
      if (const std::string limit = limit_reached(); !limit.empty()) {
        give_up(limit, session_->engine().proved_until());
        return true;
      }
      if (work_spent() >= until) return false;
      step_began_ = work_spent();
      session_->step(session_->end());
    }
    return true;
  }
  /// Everything up to this time is proved, also in the middle of an event.
  double reached() const { return session_ ? session_->engine().reached() : scene_.start; }
  /// Called between two events: the reason to stop the run, or an empty string.
  std::string limit_reached() const {
    const std::uint64_t events = session_->engine().events();
    if (events >= options_.max_events)
      return "the limit of " + std::to_string(options_.max_events) + " events was reached";
    if (events % 64 != 0) return {};
    report_parts("events", events);
    report_time(session_->engine().proved_until());
    try {
      scope_.check();
    } catch (const Interrupted& limit) {
      return limit.reason;
    }
    return {};
  }
  void give_up(const std::string& reason, double free_until) {
    answer_.reason = reason;
    answer_.free_until = free_until;
    done_ = true;
  }

  const Scene& scene_;
  const CheckOptions& options_;
  RunWatcher* watcher_;
  NearStart* near_;
  Budget scope_;
  std::unique_ptr<Session> session_;
  Answer answer_;
  bool done_ = false;
  std::uint64_t step_began_ = 0;  ///< work_spent() at that time
  std::uint64_t needed_ = 0;      ///< the minimum effort of the next slice
  std::uint64_t wanted_ = 0;      ///< by an operation for which there was no room
};

}  // namespace

std::unique_ptr<Run> begin_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher* watcher) {
  return std::make_unique<KineticRun>(scene, options, watcher);
}

namespace {

Answer run(const Scene& scene, const CheckOptions& options, RunWatcher* watcher) {
  KineticRun run(scene, options, watcher);
  run.work(UINT64_MAX);
  return with_touching(run, scene, options, [](const Scene& s, const CheckOptions& o) { return run_kinetic(s, o); });
}

}  // namespace

Answer run_kinetic(const Scene& scene, const CheckOptions& options) { return run(scene, options, nullptr); }

NearAnswer run_kinetic(const Scene& scene, const CheckOptions& options, NearStart& near) {
  const auto afresh = [](const Scene& s, const CheckOptions& o) { return run_kinetic(s, o); };
  const std::uint64_t before = work_spent();
  KineticRun run(scene, options, nullptr, &near);
  run.work(UINT64_MAX);
  const Answer answer = with_touching(run, scene, options, unless_settled_early((work_spent() - before) / 2, afresh));
  // Limits do not stop the ordinary run at the same place, and it may not need the query about touching.
  const bool settled = answer.outcome != Outcome::undecided && answer.touching_undecided.empty();
  if (run.began_near() && !settled) return {run_kinetic(scene, options), false};
  return {answer, run.began_near()};
}

Answer run_kinetic(const Scene& scene, const CheckOptions& options, RunWatcher& watcher) {
  return run(scene, options, &watcher);
}

}  // namespace taut::internal
