// The distance of bodies with curves as a function of time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "query/curved_questions.hpp"
#include "query/near_cells.hpp"
#include "scene/instance.hpp"
#include "solver/run.hpp"

namespace taut::internal {
namespace {

/// Between instants, and for the greatest distance, brackets need not be narrower than this: nearest points move along
/// curves, and every part that they pass would have to become fine.
constexpr double between_instants = 1e-4;
/// Intermediate instants are evaluated up to this number of instants.
constexpr int most_looked_between = 2000;
/// The maximum number of searches for the greatest distance, and of halvings of intervals in each.
constexpr int most_searches = 3, most_halvings = 500;

/// The distance of polygons around the bodies and of those within them, refined until they differ little where it
/// matters: first for the intervals between instants, then for the instants, which require narrower brackets.
class CurvedProfile {
 public:
  CurvedProfile(const Scene& scene, const ProfileOptions& options)
      : options_(options), began_(std::chrono::steady_clock::now()), world_(scene), limit_(world_) {
    coarse_ = std::max(options.relative, between_instants);
    absolute_ = 1e-12 * largest_size(world_);
  }

  DistanceProfile run() {
    DistanceProfile answer = refine_at_instants(coarse_, options_.instants > most_looked_between ? 1 : 2);
    if (answer.reason.empty()) answer = whole();
    if (!answer.reason.empty()) return answer;
    const DistanceProfile fine = refine_at_instants(options_.relative, 1);
    if (!fine.reason.empty()) return fine;
    take_instants(fine, answer);
    return answer;
  }

 private:
  double seconds_left() const { return time_left(options_.limits.max_seconds, began_); }

  /// Computes the whole profile, coarsely.
  DistanceProfile whole() {
    ProfileOptions own = options_;
    own.relative = coarse_ / 4;
    own.halvings = std::min(options_.halvings, most_halvings);
    for (int search = 0;; ++search) {
      own.limits.max_seconds = seconds_left();
      DistanceProfile outer = distance_profile(world_.polygons(CurveSide::outer), own);
      if (!outer.reason.empty()) return outer;
      own.limits.max_seconds = seconds_left();
      DistanceProfile inner = distance_profile(world_.polygons(CurveSide::inner), own);
      if (!inner.reason.empty()) return inner;
      CurvedWorld::Halvings marks = world_.no_halvings();
      std::size_t count = 0;
      for (std::size_t k = 0; k < inner.curves.size(); ++k)
        count += mark_largest(outer.curves[k], inner.curves[k], marks);
      if (count == 0 || search == most_searches || !finer(std::move(marks))) return between(outer, std::move(inner));
    }
  }

  /// Refines until instants are known to this accuracy; with 2 looks, also the instants halfway to the next ones.
  /// Returns the brackets, with a reason if it had to stop.
  DistanceProfile refine_at_instants(double relative, int looks) {
    ProfileOptions own = options_;
    own.relative = std::max(relative / 4, 1e-12);
    own.instants = options_.instants * looks - (looks - 1);
    for (;;) {
      own.limits.max_seconds = seconds_left();
      const DistanceProfile outer = distances_at_instants(world_.polygons(CurveSide::outer), own);
      if (!outer.reason.empty()) return outer;
      own.limits.max_seconds = seconds_left();
      DistanceProfile inner = distances_at_instants(world_.polygons(CurveSide::inner), own);
      if (!inner.reason.empty()) return inner;
      CurvedWorld::Halvings marks = world_.no_halvings();
      std::size_t count = 0;
      for (std::size_t c = 0; c < inner.curves.size(); ++c) {
        for (std::size_t k = 0; k < inner.curves[c].instants.size(); ++k) {
          const double lo = outer.curves[c].instants[k].lo;
          const DistanceAt& upper = inner.curves[c].instants[k];
          if (is_wide(lo, upper.hi, relative)) count += mark_at(inner.curves[c], upper.t, upper.hi, marks);
        }
      }
      if (count == 0 || !finer(std::move(marks))) return between(outer, std::move(inner));
    }
  }

  bool is_wide(double lo, double hi, double relative) const { return hi - lo > relative * hi + absolute_; }

  /// Marks the cells that are near at that time, for the curve's pair or for all pairs, and returns their number.
  std::size_t mark_at(const DistanceCurve& curve, double t, double distance, CurvedWorld::Halvings& marks) {
    if (curve.pair) return mark_near(world_, *curve.pair, t, distance, marks);
    std::size_t count = 0;
    for (const std::array<BodyId, 2>& pair : asked_pairs()) count += mark_near(world_, pair, t, distance, marks);
    return count;
  }

  const std::vector<std::array<BodyId, 2>>& asked_pairs() {
    if (!pairs_.empty()) return pairs_;
    const Instance instance(world_.polygons(CurveSide::inner));
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

  /// Finer polygons can narrow only a result that both searches have completed.
  std::size_t mark_largest(const DistanceCurve& outer, const DistanceCurve& inner, CurvedWorld::Halvings& marks) {
    if (!outer.settled || !inner.settled) return 0;
    if (!is_wide(outer.largest_lo, inner.largest_hi, coarse_)) return 0;
    return mark_at(outer, outer.largest_at, outer.largest_hi, marks) +
           mark_at(inner, inner.largest_at, inner.largest_hi, marks);
  }

  /// A cell that is halved twice is 16 times thinner.
  bool finer(CurvedWorld::Halvings marks) {
    if (limit_.reached(world_)) return false;
    for (auto& body : marks) {
      for (auto& part : body) {
        for (auto& ring : part) {
          for (int& mark : ring) mark *= 2;
        }
      }
    }
    return world_.refine(marks);
  }

  /// Combines the lower bounds of `outer` with the upper bounds of `inner`.
  DistanceProfile between(const DistanceProfile& outer, DistanceProfile inner) const {
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

  /// Takes the narrower brackets of instants, and their consequences for the greatest distance.
  void take_instants(const DistanceProfile& fine, DistanceProfile& answer) const {
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
      curve.settled = !is_wide(curve.largest_lo, curve.largest_hi, coarse_);
      if (!is_wide(curve.largest_lo, curve.largest_hi, options_.relative)) {
        curve.wide.clear();
      } else if (curve.settled) {
        curve.wide = fmt::format("the greatest distance of curves is found to {:g} of it, and no better", coarse_);
      } else if (curve.wide.empty()) {
        curve.wide = "a bracket as narrow as was asked for needs more edges along the curves than is reasonable";
      }
    }
    answer.geometry = CurveGeometry{widest, world_.segments()};
  }

  const ProfileOptions& options_;
  std::chrono::steady_clock::time_point began_;
  CurvedWorld world_;
  RefinementLimit limit_;
  double coarse_ = 0, absolute_ = 0;
  std::vector<std::array<BodyId, 2>> pairs_;
};

}  // namespace

DistanceProfile distance_profile_of_curves(const Scene& scene, const ProfileOptions& options) {
  return CurvedProfile(scene, options).run();
}

}  // namespace taut::internal
