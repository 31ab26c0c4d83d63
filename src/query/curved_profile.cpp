// The distance of bodies with curves as a function of time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "query/bracket.hpp"
#include "scene/instance.hpp"

namespace taut::internal {
namespace {

/// Between instants, and for the greatest distance, brackets need not be narrower than this: nearest points move along
/// curves, and every part that they pass would have to become fine.
constexpr double between_instants = 1e-4;
/// Intermediate instants are sampled up to this number of instants.
constexpr int most_sampled_between = 2000;
/// The maximum number of searches for the greatest distance, and of halvings of intervals in each.
constexpr int most_searches = 3, most_halvings = 500;

/// What both parts of the query below need.
class ProfileRun {
 public:
  ProfileRun(const Scene& scene, const ProfileOptions& options)
      : run_(scene, options.limits), absolute_(1e-12 * largest_size(run_.world())) {}

  CurvedRun& run() { return run_; }
  bool is_wide(double lo, double hi, double relative) const { return hi - lo > relative * hi + absolute_; }

  /// Marks the cells that are near at that time, for the curve's pair or for all pairs.
  void mark_at(const DistanceCurve& curve, double t, double distance, Marks& marks) {
    if (curve.pair) return marks.near(*curve.pair, t, distance);
    for (const std::array<BodyId, 2>& pair : asked_pairs()) marks.near(pair, t, distance);
  }

  /// A cell that is halved twice is 16 times thinner.
  bool refine(Marks marks) { return run_.refine(std::move(marks), 2); }

 private:
  const std::vector<std::array<BodyId, 2>>& asked_pairs() {
    if (!pairs_.empty()) return pairs_;
    const Instance instance(run_.world().polygons(CurveSide::inner));
    const int n = static_cast<int>(instance.bodies().size());
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        if (instance.asked(a, b)) pairs_.push_back(instance.scene_pair(a, b));
      }
    }
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return pairs_;
  }

  CurvedRun run_;
  double absolute_;
  std::vector<std::array<BodyId, 2>> pairs_;
};

/// Combines the lower bounds of `outer` with the upper bounds of `inner`.
DistanceProfile between(const DistanceProfile& outer, DistanceProfile inner) {
  for (std::size_t c = 0; c < inner.curves.size(); ++c) {
    DistanceCurve& curve = inner.curves[c];
    const DistanceCurve& below = outer.curves[c];
    for (std::size_t k = 0; k < curve.instants.size(); ++k)
      curve.instants[k].lo = std::min(below.instants[k].lo, curve.instants[k].hi);
    for (std::size_t k = 0; k < curve.stretches.size(); ++k)
      curve.stretches[k].lo = std::min(below.stretches[k].lo, curve.stretches[k].hi);
    curve.largest_lo = std::min(below.largest_lo, curve.largest_hi);
    curve.largest_at = below.largest_at;
  }
  return inner;
}

/// The brackets at instants, and with 2 samples also halfway to the next ones, to this accuracy. Comes with a reason if
/// it had to stop.
class InstantsBracket {
 public:
  InstantsBracket(ProfileRun& shared, const ProfileOptions& options, double relative, int samples)
      : shared_(shared), own_(options), relative_(relative) {
    own_.relative = std::max(relative / 4, 1e-12);
    own_.instants = options.instants * samples - (samples - 1);
  }

  DistanceProfile ask(CurveSide side) {
    own_.limits = shared_.run().limits_left();
    return distances_at_instants(shared_.run().world().polygons(side), own_);
  }

  static std::optional<DistanceProfile> decided_by(const DistanceProfile& outer) {
    if (!outer.reason.empty()) return outer;
    return std::nullopt;
  }
  static std::optional<DistanceProfile> decided_by(const DistanceProfile&, const DistanceProfile& inner) {
    return decided_by(inner);
  }

  bool refine(const DistanceProfile& outer, const DistanceProfile& inner) {
    Marks marks(shared_.run().world());
    for (std::size_t c = 0; c < inner.curves.size(); ++c) {
      for (std::size_t k = 0; k < inner.curves[c].instants.size(); ++k) {
        const double lo = outer.curves[c].instants[k].lo;
        const DistanceAt& upper = inner.curves[c].instants[k];
        if (shared_.is_wide(lo, upper.hi, relative_)) shared_.mark_at(inner.curves[c], upper.t, upper.hi, marks);
      }
    }
    return shared_.refine(std::move(marks));
  }

  static DistanceProfile too_fine(const DistanceProfile& outer, DistanceProfile inner) {
    return between(outer, std::move(inner));
  }

 private:
  ProfileRun& shared_;
  ProfileOptions own_;
  double relative_;
};

/// The whole profile, coarsely.
class CoarseProfile {
 public:
  CoarseProfile(ProfileRun& shared, const ProfileOptions& options, double coarse)
      : shared_(shared), own_(options), coarse_(coarse) {
    own_.relative = coarse / 4;
    own_.halvings = std::min(options.halvings, most_halvings);
  }

  DistanceProfile ask(CurveSide side) {
    own_.limits = shared_.run().limits_left();
    return distance_profile(shared_.run().world().polygons(side), own_);
  }

  static std::optional<DistanceProfile> decided_by(const DistanceProfile& outer) {
    return InstantsBracket::decided_by(outer);
  }
  static std::optional<DistanceProfile> decided_by(const DistanceProfile&, const DistanceProfile& inner) {
    return decided_by(inner);
  }

  bool refine(const DistanceProfile& outer, const DistanceProfile& inner) {
    Marks marks(shared_.run().world());
    for (std::size_t k = 0; k < inner.curves.size(); ++k) mark_largest(outer.curves[k], inner.curves[k], marks);
    return searches_++ < most_searches && shared_.refine(std::move(marks));
  }

  static DistanceProfile too_fine(const DistanceProfile& outer, DistanceProfile inner) {
    return between(outer, std::move(inner));
  }

 private:
  /// Finer polygons can narrow only a result that both searches have completed.
  void mark_largest(const DistanceCurve& outer, const DistanceCurve& inner, Marks& marks) {
    if (!outer.settled || !inner.settled) return;
    if (!shared_.is_wide(outer.largest_lo, inner.largest_hi, coarse_)) return;
    shared_.mark_at(outer, outer.largest_at, outer.largest_hi, marks);
    shared_.mark_at(inner, inner.largest_at, inner.largest_hi, marks);
  }

  ProfileRun& shared_;
  ProfileOptions own_;
  double coarse_;
  int searches_ = 0;
};

/// The distance of polygons around the bodies and of those within them, refined until they differ little where it
/// matters: first for the intervals between instants, then for the instants, which require narrower brackets.
class CurvedProfile {
 public:
  CurvedProfile(const Scene& scene, const ProfileOptions& options)
      : options_(options), shared_(scene, options), coarse_(std::max(options.relative, between_instants)) {}

  DistanceProfile run() {
    DistanceProfile answer = at_instants(coarse_, options_.instants > most_sampled_between ? 1 : 2);
    if (answer.reason.empty()) {
      CoarseProfile whole(shared_, options_, coarse_);
      answer = bracketed(whole);
    }
    if (!answer.reason.empty()) return answer;
    const DistanceProfile fine = at_instants(options_.relative, 1);
    if (!fine.reason.empty()) return fine;
    take_instants(fine, answer);
    return answer;
  }

 private:
  DistanceProfile at_instants(double relative, int samples) {
    InstantsBracket query(shared_, options_, relative, samples);
    return bracketed(query);
  }

  /// Takes the narrower brackets of instants, and their consequences for the greatest distance.
  void take_instants(const DistanceProfile& fine, DistanceProfile& answer) {
    double widest = 0;
    for (std::size_t c = 0; c < answer.curves.size(); ++c) {
      DistanceCurve& curve = answer.curves[c];
      curve.instants = fine.curves[c].instants;
      for (const DistanceAt& d : curve.instants) {
        widest = std::max(widest, d.hi - d.lo);
        if (!(d.lo > curve.largest_lo)) continue;
        curve.largest_lo = std::min(d.lo, curve.largest_hi);
        curve.largest_at = d.t;
      }
      curve.settled = !shared_.is_wide(curve.largest_lo, curve.largest_hi, coarse_);
      if (!shared_.is_wide(curve.largest_lo, curve.largest_hi, options_.relative)) {
        curve.wide.clear();
      } else if (curve.settled) {
        curve.wide = fmt::format("the greatest distance of curves is found to {:g} of it, and no better", coarse_);
      } else if (curve.wide.empty()) {
        curve.wide = "a bracket as narrow as was asked for needs more edges along the curves than is reasonable";
      }
    }
    answer.geometry = CurveGeometry{widest, shared_.run().world().segments()};
  }

  const ProfileOptions& options_;
  ProfileRun shared_;
  double coarse_;
};

}  // namespace

DistanceProfile distance_profile_of_curves(const Scene& scene, const ProfileOptions& options) {
  return CurvedProfile(scene, options).run();
}

}  // namespace taut::internal
