#include "solver/run.hpp"

#include <algorithm>

#include "numeric/slices.hpp"
#include "scene/overlap_witness.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "solver/kinetic_solver.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

using Clock = std::chrono::steady_clock;

/// A limit of events implies the engine that has events.
EngineChoice engine_for(const CheckOptions& options) {
  if (options.engine != EngineChoice::usual) return options.engine;
  return options.max_events == UINT64_MAX ? EngineChoice::either : EngineChoice::kinetic;
}

}  // namespace

Run::Run(const Scene& scene, const CheckOptions& options, KineticObserver* observer)
    : scene_(scene), options_(options), scope_(options.limits) {
  choice_.engine = engine_for(options);
  choice_.observer = observer;
  // One pair of polygons has a tiling soon.
  if (is_ring_pair(scene)) choice_.first_slice = PortfolioMember::first_turn;
  answer_.engine = options.engine == EngineChoice::kinetic ? EngineName::kinetic : EngineName::spacetime;
  answer_.free_until = scene.start;
}

void Run::run() {
  const Clock::time_point start = Clock::now();
  const std::uint64_t before = work_spent();
  try {
    scope_.check();
    prepare();
    answer_.coverage = instance_->coverage(0);
    if (answer_.coverage.is_empty()) return leave_untested();
    search_.emplace(*instance_, options_.touch, options_.all_pairs, choice_, options_.max_events);
    answer_.build_seconds = seconds_since(start);
    if (search_->start()) search_->run();
    answer_.outcome = Outcome::free;
    answer_.free_until = scene_.end;
  } catch (const Interrupted& limit) {
    stopped_ = limit.reason;
  }
  conclude();
  work_ = work_spent() - before;
  answer_.run_seconds = seconds_since(start) - answer_.build_seconds;
}

/// Not counted as work: shapes may be known to be valid, and which engine is first must not depend on that.
void Run::prepare() {
  const UnmeteredScope preparing;
  validate_polygons(scene_);
  instance_.emplace(scene_);
}

void Run::leave_untested() {
  answer_.outcome = Outcome::untested;
  answer_.reason = why_untested(answer_.coverage);
  if (options_.all_pairs) answer_.pairs.emplace();
}

void Run::conclude() {
  std::vector<PairEvent> events = pairs();
  conclude_coverage(events.size());
  if (options_.all_pairs && stopped_.empty()) {
    answer_.pairs.emplace();
    for (const PairEvent& event : events) answer_.pairs->push_back(event.pair);
  }
  std::erase_if(events, [](const PairEvent& e) { return e.pair.outcome == Outcome::free; });
  if (!stopped_.empty()) {
    // The events found so far may not be the first.
    const double proved = search_ ? search_->proved() : scene_.start;
    std::erase_if(events, [&](const PairEvent& e) { return !(time_of(e.pair) < proved); });
    answer_.outcome = Outcome::undecided;
    answer_.free_until = proved;
    answer_.reason = stopped_;
  }
  take_earliest(events, answer_);
  if (answer_.outcome == Outcome::overlap_at_start && answer_.pair)
    answer_.overlap_point = common_point(*instance_, *answer_.pair);
  name_engine();
  if (answer_.outcome == Outcome::undecided && scene_.bodies.size() == 2) answer_.pair = {0, 1};
}

/// Pairs that no engine was asked about are apart, as far as the search went.
void Run::conclude_coverage(std::uint64_t tested) {
  if (!instance_) {
    answer_.coverage = coverage_before_search(scene_);
  } else if (!stopped_.empty() && !(search_ && search_->proved() > scene_.start)) {
    answer_.coverage = coverage_when_stopped(instance_->coverage(0), tested);
  } else {
    answer_.coverage = instance_->coverage(tested);
  }
}

/// The results of the pairs that went to an engine; if they went to two, the common result. Throws EngineDisagreement.
std::vector<PairEvent> Run::pairs() const {
  std::vector<PairEvent> pairs;
  if (!search_) return pairs;
  search_->for_each_pair([&](const PairSolver& pair) {
    const PairResult* other = pair.other();
    const PairAnswer answer = answer_of(pair.result(), *instance_);
    pairs.push_back({other ? agreed_pair(answer, answer_of(*other, *instance_)) : answer, pair.instant()});
  });
  return earliest_of_each_pair(std::move(pairs));
}

/// Names the engine of the answer: if several engines solved pairs, that of the named pair. A free answer combines all
/// pairs, and is attributed to the kinetic engine as soon as one of them is.
void Run::name_engine() {
  if (!search_) return;
  // Engines agree only about what both of them decided.
  answer_.compared = options_.engine == EngineChoice::both && stopped_.empty();
  KineticCounts counts;
  search_->for_each_pair([&](const PairSolver& pair) {
    counts += pair.counts();
    const PairResult& r = pair.result();
    for (const PairResult* known : {&r, pair.other()}) {
      if (known && known->outcome == Outcome::undecided) answer_.compared = false;
    }
    const bool counts_here = !answer_.pair || *answer_.pair == instance_->scene_pair(r.a, r.b);
    if (counts_here && r.engine == EngineName::kinetic) answer_.engine = EngineName::kinetic;
  });
  // The spacetime engine has neither events nor certificates, even if the other one was tried.
  if (answer_.engine != EngineName::kinetic && !answer_.compared) return;
  answer_.events = counts.events;
  answer_.certificates_initial = counts.certificates_initial;
  answer_.certificates_max = counts.certificates_max;
}

/// For bodies that come closer than the displacement, doubles decide neither that they are disjoint nor that they
/// overlap. If doubles decided everything, both readings of touching have the same answer.
bool Run::leaves_touching_open() const {
  return answer_.outcome == Outcome::free && options_.touch == Touch::open && options_.tell_touching &&
         search_->stages().beyond_doubles() != 0;
}

/// The question about touching repeats the same search, for which the same engine is usually the better one. But many
/// simultaneous events, as in drawings on a grid, require more than doubles, and yet most bodies with such events are
/// far from touching, or touch at once. Boxes show this quickly, whereas the tiling would have to be built again and
/// process all events. Therefore boxes come first after an answer of the kinetic engine alone.
Answer Run::answer_with_touching() const {
  Answer answer = answer_;
  if (!leaves_touching_open()) return answer;
  CheckOptions closed = options_;
  closed.touch = Touch::closed;
  closed.tracer = nullptr;
  if (closed.engine == EngineChoice::kinetic) closed.engine = EngineChoice::either;
  try {
    Run again(scene_, closed);
    if (is_ring_pair(scene_)) {
      again.choice_.first = choice_.engine == EngineChoice::either ? answer.engine : EngineName::spacetime;
      again.choice_.first_slice = std::max(work_ / 2, PortfolioMember::first_turn);
    }
    again.run();
    const Answer& touching = again.answer();
    answer.touching = touching.contact;
    answer.touching_undecided = touching.reason;
    answer.run_seconds += touching.build_seconds + touching.run_seconds;
  } catch (const InputError& refused) {
    // Features are too fine to be displaced outwards.
    answer.touching_undecided = refused.what();
  }
  return answer;
}

Answer run_engines(const Scene& scene, const CheckOptions& options) {
  std::optional<TraceWriter> trace;
  if (options.tracer) {
    validate_polygons(scene);
    require_ring_pair(scene, "a trace");
    trace.emplace(*options.tracer);
  }
  Run run(scene, options, trace ? &*trace : nullptr);
  run.run();
  return run.answer_with_touching();
}

}  // namespace taut::internal
