#include "check/world_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "check/headline.hpp"
#include "pair/validate_world.hpp"

namespace taut {
namespace {

using Clock = std::chrono::steady_clock;

/// Every pair that was asked about, also those that boxes alone have told apart.
std::vector<PairAnswer> all_pairs(const WorldPlan& plan, const std::vector<PairResult>& results) {
  std::vector<PairAnswer> all;
  auto known = results.begin();
  const int n = static_cast<int>(plan.bodies().size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      if (!plan.asked(a, b)) continue;
      while (known != results.end() && std::pair(known->a, known->b) < std::pair(a, b)) ++known;
      const bool is_known = known != results.end() && known->a == a && known->b == b;
      all.push_back(is_known ? answer_of(*known) : PairAnswer{{a, b}, Outcome::free, {}, plan.end(), {}});
    }
  }
  return all;
}

}  // namespace

WorldRun::WorldRun(const Scene& scene, const CheckOptions& options)
    : scene_(scene), options_(options), scope_(options.stop, options.max_seconds) {
  answer_.engine = EngineName::spacetime;
  answer_.free_until = scene.start;
}

bool WorldRun::work(std::uint64_t) {
  const Clock::time_point start = Clock::now();
  try {
    validate_world(scene_);
    plan_.emplace(scene_);
    search_.emplace(*plan_, options_.touch, options_.all_pairs);
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

void WorldRun::conclude() {
  std::vector<PairAnswer> events;
  std::vector<PairResult> results;
  if (search_) results = search_->results();
  for (const PairResult& r : results) {
    if (r.outcome != Outcome::free) events.push_back(answer_of(r));
  }
  if (plan_) {
    if (options_.all_pairs && stopped_.empty()) answer_.pairs = all_pairs(*plan_, results);
    if (scene_.bodies.size() != 2) answer_.coverage = coverage();
  }
  if (!stopped_.empty()) {
    // What was found so far may not be the first.
    const double proved = search_ ? search_->proved() : scene_.start;
    std::erase_if(events, [&](const PairAnswer& e) { return !(time_of(e) < proved); });
    answer_.outcome = Outcome::undecided;
    answer_.free_until = proved;
    answer_.reason = stopped_;
  }
  take_headline(events, answer_);
  if (scene_.bodies.size() == 2) answer_.pair.reset();
}

Coverage WorldRun::coverage() const {
  Coverage c = plan_->coverage();
  c.checked = search_ ? search_->checked() : 0;
  c.apart = c.pairs - c.ignored - c.at_rest - c.checked;
  return c;
}

Answer run_world(const Scene& scene, const CheckOptions& options) {
  WorldRun run(scene, options);
  run.work(UINT64_MAX);
  return with_touching(run, scene, options, run_world);
}

}  // namespace taut
