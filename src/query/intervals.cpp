#include "taut/intervals.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "query/bracket.hpp"
#include "scene/mechanism_lock.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "solver/overlap_intervals.hpp"
#include "solver/run.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

using PairStretches = std::pair<std::pair<int, int>, std::vector<TimeInterval>>;

/// Of two bodies of the scene: the times at which any of their cross-sections overlap. Where the enclosures of an end
/// and of a beginning meet, one interval goes on in the other.
std::vector<OverlapInterval> united(std::vector<OverlapInterval> all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const OverlapInterval& a, const OverlapInterval& b) { return a.from.lo < b.from.lo; });
  std::vector<OverlapInterval> one;
  for (OverlapInterval& next : all) {
    if (one.empty() || one.back().to.hi < next.from.lo) {
      one.push_back(std::move(next));
      continue;
    }
    OverlapInterval& last = one.back();
    last.from.hi = std::min(last.from.hi, next.from.hi);
    if (next.to.hi > last.to.hi) last.exit = next.exit;
    last.to = {std::max(last.to.lo, next.to.lo), std::max(last.to.hi, next.to.hi)};
  }
  return one;
}

/// `sections` are those pairs of cross-sections of two bodies that come near each other. The bodies count as tested if
/// their search begins within the limits.
void search_pair(const Instance& instance, const std::vector<PairStretches>& sections, Offset offset, bool precisely,
                 const Budget& scope, Intervals& answer) {
  const std::array<BodyId, 2> pair = instance.scene_pair(sections[0].first.first, sections[0].first.second);
  std::vector<OverlapInterval> found;
  const std::string stopped = what_stops([&] {
    scope.check();
    ++answer.coverage.tested;
    for (const auto& [bodies, near] : sections) {
      for (OverlapInterval& own : overlap_intervals(instance, bodies.first, bodies.second, near, offset, precisely)) {
        own.pair = pair;
        found.push_back(std::move(own));
      }
    }
  });
  if (sections.size() > 1) found = united(std::move(found));
  for (OverlapInterval& own : found) answer.intervals.push_back(std::move(own));
  if (!stopped.empty()) answer.undecided.push_back({pair, Outcome::undecided, {}, instance.start(), stopped});
}

}  // namespace

}  // namespace taut

namespace taut::internal {

void conclude(Intervals& answer) {
  if (!answer.undecided.empty()) {
    answer.outcome = Outcome::undecided;
    answer.reason = answer.undecided.front().reason;
  } else if (!answer.intervals.empty()) {
    answer.outcome = Outcome::contact;
  }
}

Intervals intervals_of_polygons(const Scene& scene, const CheckOptions& options, bool precisely) {
  // Limits start with the first pair, so that interruptions are reported pair by pair.
  validate_polygons(scene);
  const Instance instance(scene);
  const NearStretches near(instance);
  // A single pair is searched over the whole time in one pass.
  const std::vector<TimeInterval> throughout{{instance.start(), instance.end()}};
  const bool single = instance.is_single_pair();
  const Budget scope(options.limits);
  Intervals answer;
  std::map<std::array<BodyId, 2>, std::vector<PairStretches>> by_pair;
  for (const auto& [pair, stretches] : near.pairs())
    by_pair[instance.scene_pair(pair.first, pair.second)].emplace_back(pair, single ? throughout : stretches);
  answer.coverage = instance.coverage(by_pair.size());
  answer.coverage.tested = 0;
  if (answer.coverage.is_empty()) {
    answer.outcome = Outcome::untested;
    answer.reason = why_untested(answer.coverage);
    return answer;
  }
  std::uint64_t searched = 0;
  for (const auto& [pair, sections] : by_pair) {
    report_parts("pairs", searched++, by_pair.size());
    search_pair(instance, sections, offset_for(options.touch), precisely, scope, answer);
  }
  answer.coverage.not_reached = by_pair.size() - answer.coverage.tested;
  conclude(answer);
  return answer;
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

Intervals intervals(const Scene& scene, const CheckOptions& options) {
  Intervals answer = has_curves(scene) ? intervals_of_curves(scene, options)
                                       : intervals_of_polygons(scene, options, scene.bodies.size() == 2);
  note_undecided_lock(scene, answer.outcome, answer.reason);
  return answer;
}

namespace {

/// All intervals in a part of the scene's time, of the pairs that are tested in the whole.
Intervals intervals_within(const Scene& scene, double start, double end, AtRest at_rest, const CheckOptions& options) {
  Scene part = scene;
  part.start = start;
  part.end = end;
  part.at_rest = at_rest;
  return intervals(part, options);
}

/// The overlaps from an instant on up to one end of the scene's time, at least up to the end of the first one. They are
/// asked for in windows that grow: bodies that overlap ten thousand times do so early.
class Overlaps {
 public:
  /// `end` is the scene's start or its end.
  Overlaps(const Scene& scene, double t, double end, AtRest at_rest, const CheckOptions& options) {
    constexpr double shortest = 0x1p-20, growth = 0x1p10;
    const auto began = std::chrono::steady_clock::now();
    for (double share = shortest;; share *= growth) {
      const bool all = share >= 1;
      const double limit = all ? end : t + (end - t) * share;
      CheckOptions rest = options;
      rest.limits.max_seconds = time_left(rest.limits.max_seconds, began);
      found_ = intervals_within(scene, std::min(t, limit), std::max(t, limit), at_rest, rest);
      if (all || first_is_whole(end > t)) return;
    }
  }

  const Intervals& found() const { return found_; }

 private:
  /// Does what bodies do after this window, or before it, change nothing about the first overlap?
  bool first_is_whole(bool forwards) const {
    if (found_.outcome != Outcome::contact) return false;
    const OverlapInterval* first = nullptr;
    for (const OverlapInterval& o : found_.intervals) {
      if (forwards ? !first || o.from.lo < first->from.lo : !first || o.to.hi > first->to.hi) first = &o;
    }
    if (!first) return false;
    // Who overlaps at the instant itself is refused, whatever follows.
    return forwards ? !first->enter || first->exit : !first->exit || first->enter;
  }

  Intervals found_;
};

/// What bodies do at an instant at which they are not apart: with closed touching, they may merely touch.
std::string what_they_do(const Scene& scene, double t, const std::array<BodyId, 2>& pair, Touch touch) {
  if (touch == Touch::open) return "overlap";
  std::vector<BodyId> ids;
  Scene instant = scene_of_pair(scene, pair, ids);
  instant.start = instant.end = t;
  instant.at_rest = AtRest::test;
  CheckOptions open;
  open.tell_touching = false;
  const Outcome outcome = check(instant, open).outcome;
  return outcome == Outcome::overlap_at_start ? "overlap" : outcome == Outcome::free ? "touch" : "overlap or touch";
}

[[noreturn]] void refuse_overlap(const Scene& scene, double t, const OverlapInterval& o, Touch touch) {
  const auto name = [&](BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; };
  throw InputError(
      "from",
      name(o.pair[0]) + " and " + name(o.pair[1]) + " " + what_they_do(scene, t, o.pair, touch) + " at that instant",
      "choose one at which no bodies do: `taut intervals` lists when they do");
}

}  // namespace

namespace {

/// Combines both halves: the coarser tolerance, and the larger number of edges.
std::optional<CurveGeometry> geometry_of_range(const std::optional<CurveGeometry>& before,
                                               const std::optional<CurveGeometry>& after) {
  if (!before || !after) return before ? before : after;
  return CurveGeometry{std::max(before->tolerance, after->tolerance), std::max(before->segments, after->segments)};
}

/// The coverage for the whole time: a pair may be at rest, and not be tested, on one side of the instant only.
Coverage coverage_of_range(const Instance& instance, const Intervals& before, const Intervals& after) {
  const std::uint64_t asked = instance.coverage(0).apart;
  const std::uint64_t not_reached = std::min(asked, std::max(before.coverage.not_reached, after.coverage.not_reached));
  Coverage coverage =
      instance.coverage(std::min(asked - not_reached, std::max(before.coverage.tested, after.coverage.tested)));
  coverage.apart -= not_reached;
  coverage.not_reached = not_reached;
  return coverage;
}

}  // namespace

/// Time is divided at t, so that each half determines whether bodies overlap at that instant. Ends of intervals may be
/// brackets that contain it, and bodies that separate and meet again there do both in one double.
Range range(const Scene& scene, double t, const CheckOptions& options) {
  if (!(t >= scene.start && t <= scene.end))
    throw InputError("from", "the instant is outside of the scene's time", "choose one within");
  const auto began = std::chrono::steady_clock::now();
  validate_curved_world(scene);
  const Instance whole(has_curves(scene) ? CurvedWorld(scene).polygons(CurveSide::outer) : scene);
  Intervals before, after;
  // At the very end, the time before decides: a piece of a motion that begins there is none of the scene's.
  if (t < scene.end || scene.start == scene.end)
    after = Overlaps(scene, t, scene.end, whole.at_rest(), options).found();
  if (t > scene.start) {
    CheckOptions rest = options;
    rest.limits.max_seconds = time_left(rest.limits.max_seconds, began);
    before = Overlaps(scene, t, scene.start, whole.at_rest(), rest).found();
  }
  Range range;
  range.geometry = geometry_of_range(before.geometry, after.geometry);
  range.coverage = coverage_of_range(whole, before, after);
  if (range.coverage.is_empty()) {
    range.outcome = Outcome::untested;
    range.reason = why_untested(range.coverage);
    return range;
  }
  for (const Intervals* half : {&after, &before}) {
    if (half->outcome != Outcome::undecided) continue;
    range.reason = half->reason;
    return range;
  }
  range.outcome = Outcome::free;
  for (const OverlapInterval& o : before.intervals) {
    if (!o.exit) refuse_overlap(scene, t, o, options.touch);
    if (range.from && o.to.hi <= range.from->hi) continue;
    range.from = o.to;
    range.before = o;
  }
  for (const OverlapInterval& o : after.intervals) {
    if (!o.enter) refuse_overlap(scene, t, o, options.touch);
    if (range.to && o.from.lo >= range.to->lo) continue;
    range.to = o.from;
    range.after = o;
  }
  return range;
}

}  // namespace taut
