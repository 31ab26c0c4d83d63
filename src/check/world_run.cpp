#include "check/world_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/budget.hpp"
#include "base/errors.hpp"
#include "pair/untested.hpp"
#include "pair/validate_world.hpp"
#include "world/world_feature_map.hpp"

namespace taut::internal {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

WorldRun::WorldRun(const Scene& scene, const CheckOptions& options)
    : scene_(scene), options_(options), scope_(options.limits) {
  answer_.engine = options.engine == EngineChoice::kinetic ? EngineName::kinetic : EngineName::spacetime;
  answer_.free_until = scene.start;
}

bool WorldRun::work(std::uint64_t) {
  const Clock::time_point start = Clock::now();
  try {
    validate_world(scene_);
    plan_.emplace(scene_);
    if (plan_->coverage(0).is_empty()) return leave_untested();
    search_.emplace(*plan_, options_.touch, options_.all_pairs, options_.engine, options_.max_events);
    answer_.build_seconds = seconds_since(start);
    if (search_->start()) search_->run();
    answer_.outcome = Outcome::free;
    answer_.free_until = scene_.end;
  } catch (const Interrupted& limit) {
    stopped_ = limit.reason;
  }
  conclude();
  answer_.run_seconds = seconds_since(start) - answer_.build_seconds;
  return true;
}

bool WorldRun::leave_untested() {
  answer_.outcome = Outcome::untested;
  answer_.coverage = plan_->coverage(0);
  answer_.reason = why_untested(answer_.coverage);
  if (options_.all_pairs) answer_.pairs.emplace();
  return true;
}

void WorldRun::conclude() {
  std::vector<PairEvent> events = pairs();
  if (plan_) answer_.coverage = plan_->coverage(events.size());
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
    answer_.overlap_point = common_point(*plan_, (*answer_.pair)[0], (*answer_.pair)[1]);
  name_engine();
  if (answer_.outcome == Outcome::undecided && scene_.bodies.size() == 2) answer_.pair = {0, 1};
}

/// The results of the pairs that went to an engine; if they went to two, the common result. Throws EngineDisagreement.
std::vector<PairEvent> WorldRun::pairs() const {
  std::vector<PairEvent> pairs;
  if (!search_) return pairs;
  search_->for_each_pair([&](const PairSolver& pair) {
    const PairResult* other = pair.other();
    const PairAnswer answer = answer_of(pair.result());
    pairs.push_back({other ? agreed_pair(answer, answer_of(*other)) : answer, pair.instant()});
  });
  return pairs;
}

/// Names the engine of the answer: if several engines solved pairs, that of the named pair. A free answer combines all
/// pairs, and is attributed to the kinetic engine as soon as one of them is.
void WorldRun::name_engine() {
  answer_.compared = options_.engine == EngineChoice::both;
  if (!search_) return;
  KineticCounts counts;
  search_->for_each_pair([&](const PairSolver& pair) {
    counts += pair.counts();
    const PairResult& r = pair.result();
    const bool counts_here = !answer_.pair || *answer_.pair == std::array<int, 2>{r.a, r.b};
    if (counts_here && r.engine == EngineName::kinetic) answer_.engine = EngineName::kinetic;
  });
  answer_.events = counts.events;
  answer_.certificates_initial = counts.certificates_initial;
  answer_.certificates_max = counts.certificates_max;
}

Answer run_world(const Scene& scene, const CheckOptions& options) {
  WorldRun run(scene, options);
  run.work(UINT64_MAX);
  return with_touching(run, scene, options, run_world);
}

}  // namespace taut::internal
