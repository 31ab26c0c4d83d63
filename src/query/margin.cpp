// Whether bodies keep a clearance, and the first time at which they do not.
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "certificate/feature_map.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "query/bracket.hpp"
#include "query/margins.hpp"
#include "query/nearest_points.hpp"
#include "scene/mechanism_lock.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "spacetime/clearance.hpp"
#include "spacetime/margin.hpp"
#include "taut/clearance.hpp"

namespace taut {
using namespace internal;
namespace {

using spacetime::MarginResult;

class MarginSearch {
 public:
  MarginSearch(const Scene& scene, const PairMargins& margins, const CheckOptions& options)
      : options_(options),
        instance_(scene),
        in_scene_(scene.bodies.size()),
        margins_(margins),
        offset_(offset_for(options.touch)),
        stop_(instance_.end()) {
    answer_.free_until = instance_.end();
  }

  MarginAnswer run() {
    if (instance_.coverage(0).is_empty()) return untested();
    const std::vector<std::pair<int, int>> near = pairs_in_reach();
    answer_.coverage = instance_.coverage(instance_.scene_pairs(near));
    for (const auto& [a, b] : near) {
      checkpoint();
      report_parts("pairs", asked_.size(), near.size());
      asked_.emplace_back(a, b);
      ask(a, b);
    }
    keep_first_of_each_pair(answer_.pairs);
    keep_first_of_each_pair(events_);
    take_first();
    return std::move(answer_);
  }

  /// The coverage if the search stops here.
  Coverage when_stopped() const { return coverage_when_stopped(instance_.coverage(0), instance_.scene_pairs(asked_)); }

 private:
  MarginAnswer untested() {
    answer_.outcome = Outcome::untested;
    answer_.coverage = instance_.coverage(0);
    answer_.reason = why_untested(answer_.coverage);
    answer_.free_until = instance_.start();
    return std::move(answer_);
  }

  /// In internal units.
  Margin margin_of(int a, int b) const {
    const auto [first, second] = instance_.scene_pair(a, b);
    return scaled(margins_.of(first, second), instance_.exponent());
  }
  /// Pairs that certainly stay farther apart than their margins are left out.
  std::vector<std::pair<int, int>> pairs_in_reach() const {
    const CoarseBoxes boxes(instance_);
    const std::vector<double> of_scene = margins_.shares(in_scene_, instance_.start(), instance_.end());
    std::vector<double> shares;
    for (const InstanceBody& body : instance_.bodies())
      shares.push_back(std::ldexp(of_scene[static_cast<std::size_t>(body.body)], instance_.exponent()));
    std::vector<std::pair<int, int>> near = boxes.pairs_within(shares);
    if (margins_.all_alike()) return near;
    std::erase_if(near, [&](const auto& pair) {
      const auto [a, b] = pair;
      return boxes.distance(a, b) > margin_over(margin_of(a, b), instance_.start(), instance_.end()).upper();
    });
    return near;
  }

  void ask(int a, int b) {
    PairMargin pair;
    pair.bodies = instance_.scene_pair(a, b);
    pair.margin = margins_.of(pair.bodies[0], pair.bodies[1]);
    pair.free_until = instance_.end();
    margin_ = margin_of(a, b);
    resolve(PairInstance(instance_, a, b, offset_), pair);
    pair.margin_at =
        internal::margin_at(pair.margin, pair.outcome == Outcome::contact ? pair.time.hi : pair.free_until);
    if (pair.nearest && pair.outcome == Outcome::contact) pair.nearest->hi = pair.margin_at;
    if (options_.all_pairs) answer_.pairs.push_back(pair);
    if (pair.outcome == Outcome::free) return;
    // Other pairs are followed a little further, so that those that come closer at the same time are detected.
    const double room = 0x1p-30 * (instance_.end() - instance_.start());
    if (pair.outcome == Outcome::contact && !options_.all_pairs) stop_ = std::min(stop_, pair.time.hi + room);
    events_.push_back(std::move(pair));
  }

  void resolve(const PairInstance& search, PairMargin& pair) const {
    try {
      if (spacetime::overlapping(search.geometry, search.trees(), search.segments()[0], instance_.start())) {
        pair.outcome = Outcome::overlap_at_start;
        pair.free_until = instance_.start();
        return;
      }
    } catch (const Undecidable& limit) {
      pair.outcome = Outcome::undecided;
      pair.reason = not_decided(limit);
      pair.free_until = instance_.start();
      return;
    }
    // Where bodies have been before, they were as close, but perhaps not to the same margin.
    const double until = is_constant(margin_) ? std::min(stop_, search.segments().repeats_from()) : stop_;
    take(search,
         spacetime::first_closer(search.geometry, search.trees(), search.segments(), margin_, {-INFINITY, until}),
         pair);
  }

  void take(const PairInstance& search, const MarginResult& found, PairMargin& pair) const {
    if (found.outcome == MarginResult::free) return;
    const MotionSegment& segment = search.segments()[found.segment];
    const auto time_at = [&](double t) { return std::clamp(segment.time(t), instance_.start(), instance_.end()); };
    pair.free_until = time_at(found.lo);
    if (found.outcome == MarginResult::undecided) {
      pair.outcome = Outcome::undecided;
      pair.reason = found.reason;
      return;
    }
    if (found.at_once && found.lo <= instance_.start()) return take_start(search, found, pair);
    const ContactBracket bracket = bracket_of(search, found);
    pair.outcome = Outcome::contact;
    pair.time = {time_at(bracket.lo), time_at(bracket.hi)};
    pair.grazing = bracket.grazing;
    pair.free_until = pair.time.lo;
    name_features(search, found, pair);
  }

  /// Like a contact at the start: bodies displaced outwards are as close as the margin if the given ones are, those
  /// displaced inwards only if the given ones are closer.
  void take_start(const PairInstance& search, const MarginResult& found, PairMargin& pair) const {
    const double start = instance_.start();
    if (offset_ == Offset::outward) {
      const PairInstance smaller(search.bodies, search.shared_segments, Offset::inward);
      const MarginResult closer =
          spacetime::first_closer(smaller.geometry, smaller.trees(), smaller.segments(), margin_, {start, start});
      if (closer.outcome == MarginResult::undecided) {
        pair.outcome = Outcome::undecided;
        pair.reason = closer.reason;
        return;
      }
      if (closer.outcome == MarginResult::free) {
        pair.outcome = Outcome::contact;
        pair.time = {start, start};
        name_features(search, found, pair);
        return;
      }
    }
    pair.outcome = Outcome::closer_at_start;
    pair.nearest = nearest_at_start(search);
  }

  ContactBracket bracket_of(const PairInstance& search, const MarginResult& found) const {
    const std::optional<PairGeometry> other = displaced_pair_if_possible(search.bodies, opposite(offset_));
    const MotionSegment& segment = search.segments()[found.segment];
    if (found.at_once) return {found.lo, found.hi, false};
    if (!other)
      return {offset_ == Offset::inward ? segment.start : found.lo, offset_ == Offset::inward ? found.hi : segment.end,
              true};
    const spacetime::PreciseApproaches here(search.geometry, segment, margin_), there(*other, segment, margin_);
    return bracket_of_sides(
        found.lo, found.hi, offset_, segment, [&](double t) { return here.side(found.pair, t); },
        [&](double t) { return there.side(found.pair, t); });
  }

  void name_features(const PairInstance& search, const MarginResult& found, PairMargin& pair) const {
    const VertexId vertex = found.pair.vertex, peer = found.pair.peer;
    const bool first = search.geometry.in_p(vertex);
    NearestPoints nearest =
        nearest_points_of(search, found.segment, found.hi, first ? vertex : peer, first ? peer : vertex);
    nearest.time = {pair.time.hi, pair.time.hi};
    pair.nearest = nearest;
    const FeatureMap witness(search.bodies, search.geometry, offset_);
    CloseFeatures features;
    features.vertex = witness.vertex(vertex);
    if (found.pair.is_edge) {
      features.edge = witness.edge(peer);
    } else {
      features.other = witness.vertex(peer);
    }
    pair.features = features;
  }

  NearestPoints nearest_at_start(const PairInstance& search) const {
    spacetime::Nearest found;
    // Not the margin, which may be below the resolution of doubles.
    found.distance = INFINITY;
    spacetime::find_nearest_within(search.geometry, search.trees(), search.segments(), instance_.start(),
                                   instance_.start(), {1e-9, 0}, found);
    NearestPoints nearest = nearest_points_of(search, found.segment, found.parameter, found.edge_p, found.edge_q);
    nearest.hi = std::ldexp(found.distance, -instance_.exponent());
    nearest.time = {instance_.start(), instance_.start()};
    return nearest;
  }

  /// What is so at the start comes before everything else, an overlap first.
  static std::tuple<bool, bool, double> rank(const PairMargin& p) {
    return {!at_start(p.outcome), p.outcome != Outcome::overlap_at_start, p.free_until};
  }

  /// Cross-sections of two bodies are one pair.
  static void keep_first_of_each_pair(std::vector<PairMargin>& pairs) {
    std::stable_sort(pairs.begin(), pairs.end(), [](const PairMargin& a, const PairMargin& b) {
      if (a.bodies != b.bodies) return a.bodies < b.bodies;
      if ((a.outcome == Outcome::free) != (b.outcome == Outcome::free)) return b.outcome == Outcome::free;
      return rank(a) < rank(b);
    });
    pairs.erase(std::unique(pairs.begin(), pairs.end(),
                            [](const PairMargin& a, const PairMargin& b) { return a.bodies == b.bodies; }),
                pairs.end());
  }

  /// Takes the first event, and those that are unordered with it.
  void take_first() {
    if (events_.empty()) return;
    const auto first = std::min_element(events_.begin(), events_.end(),
                                        [&](const PairMargin& x, const PairMargin& y) { return rank(x) < rank(y); });
    const auto together = [&](const PairMargin& p) {
      if (at_start(first->outcome)) return at_start(p.outcome);
      return p.outcome == Outcome::contact && first->outcome == Outcome::contact && p.time.lo <= first->time.hi &&
             first->time.lo <= p.time.hi;
    };
    answer_.outcome = first->outcome;
    answer_.free_until = first->free_until;
    answer_.reason = first->reason;
    answer_.first = *first;
    for (const PairMargin& pair : events_) {
      if (&pair != &*first && together(pair)) answer_.also.push_back(pair);
    }
  }

  const CheckOptions& options_;
  Instance instance_;
  std::size_t in_scene_;  ///< the number of the scene's bodies
  const PairMargins& margins_;
  Margin margin_;  ///< of the pair at hand, in internal units
  Offset offset_;
  double stop_;
  std::vector<std::pair<int, int>> asked_;  ///< so far
  std::vector<PairMargin> events_;
  MarginAnswer answer_;
};

}  // namespace

namespace {

MarginAnswer check_margins_of_polygons(const Scene& scene, const PairMargins& margins, const CheckOptions& options) {
  const Budget scope(options.limits);
  std::optional<MarginSearch> search;
  MarginAnswer answer;
  try {
    validate_polygons(scene);
    return search.emplace(scene, margins, options).run();
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
  }
  answer.coverage = search ? search->when_stopped() : coverage_before_search(scene);
  answer.outcome = Outcome::undecided;
  answer.free_until = scene.start;
  return answer;
}

}  // namespace

MarginAnswer internal::check_margins(const Scene& scene, const PairMargins& margins, const CheckOptions& options) {
  if (options.fit != 0)
    throw InputError("fit", "a clearance is that of bodies as they are", "leave one of the two out");
  MarginAnswer answer = has_curves(scene) ? check_margins_of_curves(scene, margins, options)
                                          : check_margins_of_polygons(scene, margins, options);
  note_lock(scene, answer.outcome, answer.reason);
  return answer;
}

MarginAnswer check_clearance(const Scene& scene, double clearance, const CheckOptions& options) {
  if (!(clearance > 0 && std::isfinite(clearance)))
    throw InputError("clearance", "it is not a positive number",
                     "without a clearance, `check` asks whether bodies touch");
  return check_margins(scene, PairMargins(scene, clearance), options);
}

}  // namespace taut
