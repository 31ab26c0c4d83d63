// Runs two engines in alternating slices. Each is far ahead of the other on some motions, and it is not known
// beforehand on which.
#include <memory>
#include <string>

#include "base/slices.hpp"
#include "check/run.hpp"
#include "numeric/undecided.hpp"
#include "pair/pair_plan.hpp"

namespace taut::internal {
namespace {

/// One of the engines, and the work that it has done.
class PortfolioEngine {
 public:
  PortfolioEngine(EngineName engine, const Scene& scene, const CheckOptions& options)
      : engine_(engine), scene_(scene), options_(options) {}

  void begin() {
    effort_.begin([&] {
      run_ = engine_ == EngineName::kinetic ? begin_kinetic(scene_, options_) : begin_spacetime(scene_, options_);
    });
  }
  SliceResult work(std::uint64_t effort) {
    if (!run_->work(effort)) return SliceResult::open;
    return run_->answer().outcome == Outcome::undecided ? SliceResult::given_up : SliceResult::decided;
  }
  bool decides_by(std::uint64_t total) {
    return effort_.work_until(total, [this](std::uint64_t effort) { return work(effort); }) == SliceResult::decided;
  }
  EngineName engine() const { return engine_; }
  const Run& run() const { return *run_; }
  PortfolioMember& effort() { return effort_; }

 private:
  EngineName engine_;
  const Scene& scene_;
  const CheckOptions& options_;
  std::unique_ptr<Run> run_;
  PortfolioMember effort_;
};

/// The engine that begins, and the additional work that it may do before the other one begins.
struct Lead {
  EngineName engine;
  std::uint64_t work;
};

/// The caller has also waited for the work of the other engine.
void add_time(const Answer& spent, Answer& answer) {
  answer.build_seconds += spent.build_seconds;
  answer.run_seconds += spent.run_seconds;
}

Answer answer_in_turns(const Scene& scene, const CheckOptions& options, const Lead& lead) {
  const bool kinetic_first = lead.engine == EngineName::kinetic;
  PortfolioEngine first(lead.engine, scene, options);
  PortfolioEngine second(kinetic_first ? EngineName::spacetime : EngineName::kinetic, scene, options);
  const auto finished = [&](PortfolioEngine& winner, PortfolioEngine* other) {
    // The query about touching repeats the same search, for which the same engine is usually the better one. But if the
    // other engine is nearly done, too, its answer may not leave touching open.
    const std::uint64_t longer = winner.effort().spent() + winner.effort().spent() / 2;
    const auto settles = [&] {
      return other->decides_by(longer) && other->run().answer().outcome == Outcome::free &&
             !leaves_touching_open(other->run(), options);
    };
    PortfolioEngine *decided = &winner, *left = other;
    if (other && leaves_touching_open(winner.run(), options) && settles()) std::swap(decided, left);
    const CheckFunction again = [&](const Scene& s, const CheckOptions& o) {
      return answer_in_turns(s, o, {winner.engine(), longer});
    };
    Answer answer = with_touching(decided->run(), scene, options, again);
    if (left) add_time(left->run().answer(), answer);
    return answer;
  };
  first.begin();
  if (first.decides_by(first.effort().spent() + lead.work)) return finished(first, nullptr);
  second.begin();
  const auto by_first = [&](std::uint64_t effort) { return first.work(effort); };
  const auto by_second = [&](std::uint64_t effort) { return second.work(effort); };
  const int decided = take_turns(second.effort(), by_second, first.effort(), by_first);
  if (decided == 1) return finished(second, &first);
  if (decided == 2) return finished(first, &second);
  // Limits stopped both: take the answer of the engine that has proved more of the time free.
  const Answer &a = first.run().answer(), &b = second.run().answer();
  if (a.free_until == b.free_until) return kinetic_first ? a : b;
  return a.free_until > b.free_until ? a : b;
}

}  // namespace

Answer run_either(const Scene& scene, const CheckOptions& options) {
  // Both engines, and the query about touching, share the data that depends on the shapes alone. That work is not
  // counted, so that the order of the engines does not depend on what was prepared beforehand.
  Scene prepared;
  const std::string stopped = what_stops([&] { prepared = with_prepared_shapes(scene); });
  if (!stopped.empty()) {
    // Stopped by an enclosing budget, before any search.
    Answer answer;
    answer.outcome = Outcome::undecided;
    answer.engine = EngineName::spacetime;
    answer.free_until = scene.start;
    answer.reason = stopped;
    return answer;
  }
  return answer_in_turns(prepared, options, {EngineName::spacetime, PortfolioMember::first_turn});
}

}  // namespace taut::internal
