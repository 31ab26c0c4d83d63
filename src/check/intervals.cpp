#include "taut/intervals.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "check/curved_questions.hpp"
#include "numeric/undecided.hpp"
#include "pair/untested.hpp"
#include "pair/validate_world.hpp"
#include "search/overlap_intervals.hpp"
#include "taut/error.hpp"
#include "world/near_stretches.hpp"

namespace taut {
namespace {

void search_pair(const WorldPlan& plan, int a, int b, const std::vector<TimeInterval>& near, bool inwards, bool plain,
                 Intervals& answer) {
  const std::string stopped = what_stops([&] {
    for (OverlapInterval& found : overlap_intervals(plan, a, b, near, inwards, plain))
      answer.intervals.push_back(std::move(found));
  });
  if (!stopped.empty()) answer.undecided.push_back({{a, b}, Outcome::undecided, {}, plan.start(), stopped});
}

}  // namespace

void conclude(Intervals& answer) {
  if (!answer.undecided.empty()) {
    answer.outcome = Outcome::undecided;
    answer.reason = answer.undecided.front().reason;
  } else if (!answer.intervals.empty()) {
    answer.outcome = Outcome::contact;
  }
}

Intervals intervals(const Scene& scene, const CheckOptions& options) {
  if (has_curves(scene)) return intervals_of_curves(scene, options);
  // Limits begin with the first pair: what they end is then said pair by pair.
  validate_world(scene);
  const WorldPlan plan(scene);
  const NearStretches near(plan);
  // Of two plain polygons it is all of the time that is looked at, in one walk.
  const std::vector<TimeInterval> throughout{{plan.start(), plan.end()}};
  const bool plain = !is_world(scene);
  const InterruptionScope scope(options.stop, options.max_seconds);
  Intervals answer;
  answer.coverage = plan.coverage(near.pairs().size());
  if (answer.coverage.is_empty()) {
    answer.outcome = Outcome::untested;
    answer.reason = why_untested(answer.coverage);
    return answer;
  }
  for (const auto& [pair, stretches] : near.pairs())
    search_pair(plan, pair.first, pair.second, plain ? throughout : stretches, options.touch == Touch::open, plain,
                answer);
  conclude(answer);
  return answer;
}

Range range(const Scene& scene, double t, const CheckOptions& options) {
  if (!(t >= scene.start && t <= scene.end))
    throw InputError("from", "the instant is outside of the scene's time", "choose one within");
  const Intervals all = intervals(scene, options);
  Range range;
  range.geometry = all.geometry;
  range.coverage = all.coverage;
  range.reason = all.reason;
  if (all.outcome == Outcome::undecided || all.outcome == Outcome::untested) {
    range.outcome = all.outcome;
    return range;
  }
  range.outcome = Outcome::free;
  for (const OverlapInterval& o : all.intervals) {
    if (o.to.hi <= t && o.to.hi < scene.end) {
      if (!range.from || o.to.hi > range.from->hi) {
        range.from = o.to;
        range.before = o;
      }
    } else if (o.from.lo >= t && o.from.lo > scene.start) {
      if (!range.to || o.from.lo < range.to->lo) {
        range.to = o.from;
        range.after = o;
      }
    } else {
      const auto name = [&](BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; };
      throw InputError("from", name(o.pair[0]) + " and " + name(o.pair[1]) + " overlap at that instant",
                       "choose one at which no bodies do: `taut intervals` lists when they do");
    }
  }
  return range;
}

}  // namespace taut
