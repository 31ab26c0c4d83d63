#include "taut/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "certificate/feature_map.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "query/bracket.hpp"
#include "query/nearest_points.hpp"
#include "scene/mechanism_lock.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "solver/pair_solver.hpp"
#include "solver/run.hpp"
#include "spacetime/clearance.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// It is undecided whether bodies touch, for this reason.
struct TouchUndecided {
  std::string reason;
};

class ClearanceSearch {
 public:
  ClearanceSearch(const Scene& scene, const ClearanceOptions& options)
      : options_(options), instance_(scene), boxes_(instance_), best_(INFINITY) {
    // A little less than the tolerance; the rest is for rounding.
    tolerance_ = {options.relative * 0.99, 0.99e-12 * instance_.largest()};
    if (options.all_pairs) listed_within_ = std::ldexp(options.within, instance_.exponent());
  }

  /// The coverage if the search stops here.
  Coverage when_stopped() const {
    return coverage_when_stopped(instance_.coverage(0), instance_.scene_pairs(searched_));
  }

  Clearance run() {
    answer_.coverage = instance_.coverage(0);
    if (answer_.coverage.is_empty()) {
      answer_.outcome = Outcome::untested;
      answer_.reason = why_untested(answer_.coverage);
      return std::move(answer_);
    }
    search_all();
    resolve_all();
    answer_.coverage = instance_.coverage(instance_.scene_pairs(searched_));
    if (answer_.nearest) {
      answer_.outcome = answer_.nearest->hi > 0 ? Outcome::free : Outcome::contact;
      answer_.nearest->lo = std::min(answer_.nearest->lo, std::ldexp(certain_, -instance_.exponent()) * (1 - 0x1p-50));
      const NearestPoints& found = *answer_.nearest;
      answer_.wide = is_wide(found) && !why_.empty() ? why_ : why_wide(found.lo, found.hi, options_.relative);
    }
    keep_nearest_of_each_pair();
    return std::move(answer_);
  }

 private:
  struct BoxedPair {
    double bound;
    int a, b;
  };

  /// Cross-sections of two bodies are one pair. In the order of the scene.
  void keep_nearest_of_each_pair() {
    std::vector<NearestPoints>& pairs = answer_.pairs;
    std::sort(pairs.begin(), pairs.end(), [](const NearestPoints& a, const NearestPoints& b) {
      return a.pair != b.pair ? a.pair < b.pair : is_nearer(a, b);
    });
    for (std::size_t i = 1; i < pairs.size(); ++i) {
      // The first one is the nearest as far as is known; another one may be nearer by what is not.
      if (pairs[i].pair == pairs[i - 1].pair) pairs[i - 1].lo = std::min(pairs[i - 1].lo, pairs[i].lo);
    }
    pairs.erase(std::unique(pairs.begin(), pairs.end(),
                            [](const NearestPoints& a, const NearestPoints& b) { return a.pair == b.pair; }),
                pairs.end());
  }

  bool is_wide(const NearestPoints& found) const {
    return found.hi - found.lo > options_.relative * found.hi + 1e-12 * largest();
  }
  /// In the scene's units.
  double largest() const { return std::ldexp(instance_.largest(), -instance_.exponent()); }

  /// Searches pairs in the order of the distance of their boxes, in rounds of increasing reach, until no other pair can
  /// be closer than the distance found. If that is 0, all pairs whose boxes meet are searched for the first touch.
  /// Those that may be listed come first, all of them.
  void search_all() {
    double reach = std::max(listed_within_, 0.0);
    for (;;) {
      for (const BoxedPair& pair : new_pairs(reach)) {
        if (!is_listed(pair) && pair.bound > (best_ > 0 ? tolerance_.least(best_) : 0)) return;
        report_parts("pairs", searched_.size());
        searched_.emplace(pair.a, pair.b);
        search(pair);
      }
      if (reach >= tolerance_.least(best_)) return;
      // Without any distance so far: at least the size of a body, doubled each time.
      reach = best_ < INFINITY ? best_ : std::max(2 * reach, 0x1p-6 * instance_.largest());
      if (!(reach < 64)) reach = INFINITY;
    }
  }

  bool is_listed(const BoxedPair& pair) const { return pair.bound <= listed_within_; }

  /// The pairs within reach that have not been searched, the nearest boxes first.
  std::vector<BoxedPair> new_pairs(double reach) const {
    std::vector<BoxedPair> pairs;
    for (const auto& [a, b] : boxes_.pairs_within(reach)) {
      checkpoint();
      if (searched_.count({a, b}) == 0) pairs.push_back({boxes_.distance(a, b), a, b});
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const BoxedPair& x, const BoxedPair& y) { return x.bound < y.bound; });
    return pairs;
  }

  /// A pair whose distances have been searched, but perhaps not resolved to the tolerance.
  struct SearchedPair {
    BoxedPair boxed;
    std::unique_ptr<PairInstance> search;
    spacetime::Nearest nearest;
    bool is_nearest;  ///< of all pairs before it
  };

  void search(const BoxedPair& pair) {
    SearchedPair searched{pair, std::make_unique<PairInstance>(instance_, pair.a, pair.b, Offset::outward), {}, false};
    const PairInstance& search = *searched.search;
    NearestPoints found;
    found.pair = instance_.scene_pair(pair.a, pair.b);
    if (touching(search, found)) return take(pair, found);
    if (!is_listed(pair) && !(best_ > 0)) return;
    spacetime::Nearest& nearest = searched.nearest;
    const double before = is_listed(pair) ? INFINITY : best_;
    nearest.distance = before;
    const double end = std::min(instance_.end(), search.segments().repeats_from());
    spacetime::find_nearest(search.geometry, search.trees(), search.segments(), end, tolerance_, nearest);
    searched.is_nearest = nearest.distance < before;
    if (is_listed(pair) || !(nearest.unresolved < tolerance_.least(nearest.distance))) return resolve(searched);
    // What doubles do not resolve is expensive, and another pair may be nearer.
    best_ = std::min(best_, nearest.distance);
    unresolved_.push_back(std::move(searched));
  }

  void resolve_all() {
    for (SearchedPair& searched : unresolved_) {
      if (!(best_ > 0)) break;
      if (best_ < searched.nearest.distance) {
        searched.nearest.distance = best_;
        searched.is_nearest = false;
      }
      resolve(searched);
    }
    unresolved_.clear();
  }

  void resolve(SearchedPair& searched) {
    const PairInstance& search = *searched.search;
    spacetime::Nearest& nearest = searched.nearest;
    const double before = nearest.distance;
    const double end = std::min(instance_.end(), search.segments().repeats_from());
    const std::string why = spacetime::resolve_nearest(search.geometry, search.trees(), search.segments(),
                                                       {instance_.start(), end}, tolerance_, nearest);
    certain_ = std::min(certain_, nearest.unresolved);
    if (!why.empty()) why_ = why;
    if (!is_listed(searched.boxed) && !searched.is_nearest && !(nearest.distance < before)) return;
    NearestPoints found;
    found.pair = instance_.scene_pair(searched.boxed.a, searched.boxed.b);
    describe(search, nearest, found);
    take(searched.boxed, found);
  }

  void take(const BoxedPair& pair, const NearestPoints& found) {
    if (is_listed(pair) && found.lo <= options_.within) answer_.pairs.push_back(found);
    if (answer_.nearest && !is_nearer(found, *answer_.nearest)) return;
    answer_.nearest = found;
    best_ = std::min(best_, std::ldexp(found.hi, instance_.exponent()));
  }

  /// Of two pairs that touch, the one that does so first.
  static bool is_nearer(const NearestPoints& a, const NearestPoints& b) {
    if (a.hi != b.hi) return a.hi < b.hi;
    return !(a.hi > 0) && a.time.lo < b.time.lo;
  }

  /// Bodies that touch have no distance.
  bool touching(const PairInstance& search, NearestPoints& found) const {
    const MotionSegment& first = search.segments()[0];
    if (spacetime::overlapping(search.geometry, search.trees(), first, instance_.start())) {
      found.time = {instance_.start(), instance_.start()};
      return true;
    }
    const spacetime::SpacetimeResult contact =
        spacetime::first_contact(search.geometry, search.trees(), search.segments());
    if (contact.outcome == spacetime::SpacetimeResult::free) return false;
    if (contact.outcome == spacetime::SpacetimeResult::undecided) throw TouchUndecided{contact.reason};
    const MotionSegment& segment = search.segments()[contact.segment];
    const Contact said = FeatureMap(search.bodies, search.geometry, Offset::outward).contact(contact.found, segment);
    found.time = said.time;
    found.points = {said.point, said.point};
    return true;
  }

  void describe(const PairInstance& search, const spacetime::Nearest& nearest, NearestPoints& found) const {
    found = nearest_points_of(search, nearest.segment, nearest.parameter, nearest.edge_p, nearest.edge_q);
    const MotionSegment& segment = search.segments()[nearest.segment];
    const double t = std::clamp(segment.time(nearest.parameter), instance_.start(), instance_.end());
    found.time = {t, t};
    found.hi = std::ldexp(nearest.distance, -instance_.exponent());
    const double least = std::min(tolerance_.least(nearest.distance), nearest.unresolved);
    found.lo = std::max(0.0, std::ldexp(least, -instance_.exponent()) * (1 - 0x1p-50));
  }

  const ClearanceOptions& options_;
  Instance instance_;
  CoarseBoxes boxes_;
  std::set<std::pair<int, int>> searched_;
  spacetime::ClearanceTolerance tolerance_;
  double best_;  ///< internal units
  std::vector<SearchedPair> unresolved_;
  double listed_within_ = -1;  ///< internal units; of no pair by default
  double certain_ = INFINITY;  ///< a lower bound of the distance of all pairs that are not known to the requested
                               ///< accuracy
  std::string why_;            ///< the reason for that
  Clearance answer_;
};

}  // namespace

namespace {

Clearance clearance_of_polygons(const Scene& scene, const ClearanceOptions& options) {
  const Budget scope(options.limits);
  std::optional<ClearanceSearch> search;
  std::string stopped;
  try {
    std::optional<Clearance> answer;
    stopped = what_stops([&] {
      validate_polygons(scene);
      answer = search.emplace(scene, options).run();
    });
    if (answer) return *answer;
  } catch (const TouchUndecided& limit) {
    stopped = limit.reason;
  }
  Clearance undecided;
  undecided.coverage = search ? search->when_stopped() : coverage_before_search(scene);
  undecided.reason = stopped;
  return undecided;
}

}  // namespace

Clearance clearance(const Scene& scene, const ClearanceOptions& options) {
  if (!(options.relative >= 1e-12 && options.relative < 1))
    throw InputError("tolerance", "it is not at least 1e-12 and below 1",
                     "1e-9 is usual; doubles do not resolve more than 1e-12");
  if (!(options.within > 0)) throw InputError("within", "it is not a positive distance", "leave it out for all pairs");
  if (options.within < ClearanceOptions{}.within && !options.all_pairs)
    throw InputError("within", "it says which pairs are listed, and none is", "ask for all pairs");
  Clearance answer = has_curves(scene) ? clearance_of_curves(scene, options) : clearance_of_polygons(scene, options);
  note_undecided_lock(scene, answer.outcome, answer.reason);
  return answer;
}

}  // namespace taut
