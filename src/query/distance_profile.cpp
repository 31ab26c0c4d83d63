// The distance of bodies as a function of time: at instants, between them, and the greatest one.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "query/bracket.hpp"
#include "query/nearest_points.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "solver/distance_curve.hpp"
#include "solver/run.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// An interval that may contain the greatest distance. Those with the greatest upper bound are halved first.
struct Candidate {
  double most, from, to;
  /// Of equal candidates, as in symmetric scenes, the earliest comes first, independent of the implementation of the
  /// queue.
  bool operator<(const Candidate& o) const { return most != o.most ? most < o.most : from > o.from; }
};

/// Intervals are in the order of their pairs.
struct ByPair {
  bool operator()(const OverlapInterval& o, const std::array<BodyId, 2>& pair) const { return o.pair < pair; }
  bool operator()(const std::array<BodyId, 2>& pair, const OverlapInterval& o) const { return pair < o.pair; }
};

class ProfileSearch {
 public:
  /// Searches only the instants, or the whole profile.
  ProfileSearch(const Scene& scene, const ProfileOptions& options, bool only_instants)
      : options_(options), only_instants_(only_instants), instance_(scene) {
    // A little less than the tolerance; the rest is for rounding.
    tolerance_ = {options.relative * 0.99, 0.99e-12 * instance_.largest()};
    absolute_ = std::ldexp(1e-12 * instance_.largest(), -instance_.exponent());
  }

  DistanceProfile run(const Intervals& touching) {
    find_pairs(touching);
    std::vector<const PairDistance*> all;
    for (const PairDistance& pair : pairs_) all.push_back(&pair);
    answer_.curves.push_back(curve(all));
    std::map<std::array<BodyId, 2>, std::vector<const PairDistance*>> by_pair;
    for (const PairDistance& pair : pairs_) by_pair[pair.pair].push_back(&pair);
    answer_.coverage = instance_.coverage(by_pair.size());
    if (options_.all_pairs && by_pair.size() > 1) {
      for (const auto& [pair, sections] : by_pair) answer_.curves.push_back(curve(sections));
    }
    return std::move(answer_);
  }

 private:
  void find_pairs(const Intervals& touching) {
    const int n = static_cast<int>(instance_.bodies().size());
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        if (!instance_.asked(a, b)) continue;
        checkpoint();
        pairs_.push_back({instance_.scene_pair(a, b), PairInstance(instance_, a, b, Offset::outward), {}});
        const auto own =
            std::equal_range(touching.intervals.begin(), touching.intervals.end(), pairs_.back().pair, ByPair());
        pairs_.back().touching.assign(own.first, own.second);
      }
    }
  }

  double instant(int k) const {
    const double share = static_cast<double>(k) / (options_.instants - 1);
    return k + 1 == options_.instants ? instance_.end()
                                      : instance_.start() + (instance_.end() - instance_.start()) * share;
  }

  DistanceCurve curve(const std::vector<const PairDistance*>& pairs) const {
    const DistanceFunction distance(pairs, tolerance_, instance_.exponent());
    DistanceCurve curve;
    const auto same = [&](const PairDistance* p) { return p->pair == pairs[0]->pair; };
    if (!pairs.empty() && std::all_of(pairs.begin(), pairs.end(), same)) curve.pair = pairs[0]->pair;
    for (int k = 0; k < options_.instants; ++k) curve.instants.push_back(distance.at(instant(k)));
    if (only_instants_) return curve;
    for (int k = 0; k + 1 < options_.instants; ++k) {
      if (!(instant(k) < instant(k + 1))) continue;
      curve.stretches.push_back(distance.within(instant(k), instant(k + 1)));
      DistanceWithin& s = curve.stretches.back();
      const auto n = static_cast<std::size_t>(k);
      const double ends = std::max(curve.instants[n].hi, curve.instants[n + 1].hi);
      s.hi = std::min(s.hi, narrowed(distance, s, s.hi, std::max(1.02 * ends, ends + absolute_), 4));
    }
    find_largest(distance, curve);
    return curve;
  }

  /// Tightens the bound of the greatest distance by halving, as long as it is above `enough`.
  double narrowed(const DistanceFunction& distance, const DistanceWithin& s, double most, double enough,
                  int depth) const {
    const double middle = s.from + (s.to - s.from) / 2;
    if (most <= enough || depth == 0 || !(s.from < middle && middle < s.to)) return most;
    const DistanceWithin first{s.from, middle, 0, 0}, second{middle, s.to, 0, 0};
    return std::max(narrowed(distance, first, distance.most(s.from, middle), enough, depth - 1),
                    narrowed(distance, second, distance.most(middle, s.to), enough, depth - 1));
  }

  bool is_close(double lo, double hi) const { return hi - lo <= options_.relative * hi + absolute_; }

  static void raise(DistanceCurve& curve, const DistanceAt& d) {
    curve.largest_hi = std::max(curve.largest_hi, d.hi);
    if (!(d.lo > curve.largest_lo)) return;
    curve.largest_lo = d.lo;
    curve.largest_at = d.t;
  }

  void find_largest(const DistanceFunction& distance, DistanceCurve& curve) const {
    curve.largest_at = curve.instants[0].t;
    for (const DistanceAt& d : curve.instants) raise(curve, d);
    std::priority_queue<Candidate> candidates;
    for (const DistanceWithin& s : curve.stretches) candidates.push({s.hi, s.from, s.to});
    curve.settled = true;
    for (int k = 0; !candidates.empty(); ++k) {
      const Candidate top = candidates.top();
      curve.largest_hi = std::max(curve.largest_lo, top.most);
      if (is_close(curve.largest_lo, top.most)) {
        curve.wide = why_wide(curve.largest_lo, curve.largest_hi, options_.relative);
        return;
      }
      const double middle = top.from + (top.to - top.from) / 2;
      curve.settled = k < options_.halvings && top.from < middle && middle < top.to;
      if (!curve.settled) {
        curve.wide = k < options_.halvings ? "doubles do not divide the time further"
                                           : "the greatest distance may be at more times than were tried: more "
                                             "instants, or a larger tolerance, leave fewer";
        return;
      }
      candidates.pop();
      raise(curve, distance.at(middle));
      // Where bounds are rough, those of halves may be no better than that of the whole.
      candidates.push({std::min(top.most, distance.most(top.from, middle)), top.from, middle});
      candidates.push({std::min(top.most, distance.most(middle, top.to)), middle, top.to});
    }
  }

  const ProfileOptions& options_;
  bool only_instants_;
  Instance instance_;
  spacetime::ClearanceTolerance tolerance_;
  double absolute_ = 0;
  std::vector<PairDistance> pairs_;
  DistanceProfile answer_;
};

void validate_profile(const ProfileOptions& options) {
  if (!(options.relative >= 1e-12 && options.relative < 1))
    throw InputError("tolerance", "it is not at least 1e-12 and below 1",
                     "1e-9 is usual; doubles do not resolve more than 1e-12");
  if (options.instants < 2 || options.instants > 1000000)
    throw InputError("profile", "it has " + std::to_string(options.instants) + " instants",
                     "2 to 1000000 can be asked for");
}

DistanceProfile profile_of_polygons(const Scene& scene, const ProfileOptions& options, bool only_instants) {
  CheckOptions closed;
  closed.touch = Touch::closed;
  closed.limits.max_seconds = options.limits.max_seconds;
  closed.limits.stop = options.limits.stop;
  const Intervals touching = intervals(scene, closed);
  DistanceProfile answer;
  answer.outcome = touching.outcome;
  answer.reason = touching.reason;
  answer.coverage = coverage_when_stopped(touching.coverage, touching.coverage.tested);
  if (touching.outcome == Outcome::undecided || touching.outcome == Outcome::untested) return answer;
  const Budget scope(options.limits);
  const auto search = [&] { answer = ProfileSearch(scene, options, only_instants).run(touching); };
  answer.reason = what_stops(search);
  answer.outcome = answer.reason.empty() ? touching.outcome : Outcome::undecided;
  return answer;
}

}  // namespace

}  // namespace taut

namespace taut::internal {

DistanceProfile distances_at_instants(const Scene& scene, const ProfileOptions& options) {
  return profile_of_polygons(scene, options, true);
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

DistanceProfile distance_profile(const Scene& scene, const ProfileOptions& options) {
  validate_profile(options);
  if (has_curves(scene)) return distance_profile_of_curves(scene, options);
  return profile_of_polygons(scene, options, false);
}

}  // namespace taut
