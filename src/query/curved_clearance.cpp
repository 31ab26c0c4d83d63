// The least distance of bodies with curves, and whether they keep a clearance.
#include <algorithm>
#include <cmath>

#include "geometry/vector.hpp"
#include "motion/pose.hpp"
#include "numeric/budget.hpp"
#include "query/bracket.hpp"
#include "query/margins.hpp"
#include "query/nearest_points.hpp"
#include "scene/instance.hpp"

namespace taut::internal {
namespace {

double name_edges(const CurvedWorld& world, NearestPoints& nearest) {
  return std::max(world.name_curve(CurveSide::inner, nearest.edges[0]),
                  world.name_curve(CurveSide::inner, nearest.edges[1]));
}

/// Bodies that certainly touch have no distance. The check determines when they do.
Clearance touching_curves(const Scene& scene, const ClearanceOptions& options, Clearance found) {
  CheckOptions own;
  own.touch = Touch::closed;
  own.engine = EngineChoice::spacetime;
  own.limits.max_seconds = options.limits.max_seconds;
  own.limits.stop = options.limits.stop;
  const Answer answer = check_curved(scene, own);
  if (!answer.contact) return found;
  if (answer.pair) found.nearest->pair = *answer.pair;
  found.nearest->time = answer.contact->time;
  found.nearest->points = {answer.contact->point, answer.contact->point};
  found.nearest->edges = {answer.contact->edge, answer.contact->edge};
  found.geometry = answer.geometry;
  return found;
}

/// An upper bound, in the scene's units, of the jump of two bodies relative to each other where pieces of motions join.
/// Poses are linear in the point, so the corners of a body's box suffice.
double largest_jump(const Scene& polygons) {
  const Instance instance(polygons);
  double largest = 0, reach = 0;
  for (const InstanceBody& body : instance.bodies()) {
    const AxisBox& box = body.rings->bounds();
    const auto corner_at = [&](double of, double t, int corner) {
      const Pose<double> pose = pose_of<Jet<double>>(pieces_at(body.motions, of), Ball<double>::exact(t));
      const Vector p{corner & 1 ? box.hi_x : box.lo_x, corner & 2 ? box.hi_y : box.lo_y};
      return Vector{pose.ox.v.mid, pose.oy.v.mid} + Vector{pose.xx.v.mid, pose.xy.v.mid} * p;
    };
    for (const PieceList& motion : body.motions) {
      for (std::size_t k = 0; k + 1 < motion.size() && motion.until(k) < instance.end(); ++k) {
        const double t = motion.until(k);
        for (int corner = 0; corner < 4; ++corner) {
          const Vector after = corner_at(t, t, corner);
          largest = std::max(largest, l1_norm(corner_at(std::nextafter(t, instance.start()), t, corner) - after));
          reach = std::max(reach, l1_norm(after));
        }
      }
    }
  }
  return std::ldexp(2 * (largest + 0x1p-40 * reach), -instance.exponent());
}

/// The least distance of all pairs, between those of polygons around the bodies and within them. Where curves run along
/// each other, all of them would have to be fine. In that case the search ends as soon as this is foreseen, with the
/// current bracket.
class ClearanceBracket {
 public:
  ClearanceBracket(const Scene& scene, const ClearanceOptions& options)
      : scene_(scene), options_(options), run_(scene, options.limits), own_(options) {
    own_.all_pairs = false;
    own_.within = ClearanceOptions{}.within;
    own_.relative = std::max(options.relative / 4, 0.01);
    most_ = 4 * run_.world().segments() + 3000;
    size_ = largest_size(run_.world());
  }

  Clearance ask(CurveSide side) {
    own_.limits = run_.limits_left();
    Clearance answer = clearance(run_.world().polygons(side), own_);
    answer.geometry = run_.geometry();
    return answer;
  }

  std::optional<Clearance> decided_by(const Clearance& outer) const {
    if (!outer.reason.empty() || !outer.nearest) return outer;
    return std::nullopt;
  }

  std::optional<Clearance> decided_by(const Clearance& outer, const Clearance& inner) const {
    if (!inner.reason.empty() || !inner.nearest) return inner;
    if (width(outer, inner) <= wanted_width(inner.nearest->hi)) return with_reason(concluded(outer, inner));
    return std::nullopt;
  }

  /// Refines near the nearest points. Returns false if that is in vain, or the resolution of doubles is reached.
  bool refine(const Clearance& outer, const Clearance& inner) {
    const double now = width(outer, inner);
    note_progress(now);
    // Not much finer than the polygons: the uncertainty that they leave has to be resolved anyway.
    own_.relative = std::max(options_.relative / 4, std::min(own_.relative, 0.02 * now / inner.nearest->hi));
    return refine_near(outer, inner, now / wanted_width(inner.nearest->hi));
  }

  Clearance too_fine(const Clearance& outer, Clearance inner) const {
    Clearance answer = concluded(outer, std::move(inner));
    raise_lower_end(answer);
    if (answer.nearest->hi - answer.nearest->lo > wanted_width(answer.nearest->hi))
      answer.wide =
          "curves run along each other: a bracket as narrow as was asked for needs more edges than is "
          "reasonable, and a larger tolerance fewer";
    if (answer.outcome == Outcome::undecided && answer.nearest->lo > 0) answer.outcome = Outcome::free;
    if (answer.outcome == Outcome::undecided) answer.reason = answer.wide;
    return with_reason(std::move(answer));
  }

 private:
  static double width(const Clearance& outer, const Clearance& inner) { return inner.nearest->hi - outer.nearest->lo; }

  /// It is easier to decide whether a margin is kept: curves need to be fine only where they come so near, one instant
  /// after the other. Tests margins nearer and nearer to the upper end, with a few times the total work so far. If the
  /// bracket is narrow already, that would take long for a small gain.
  void raise_lower_end(Clearance& answer) const {
    constexpr int most_margins = 40;
    constexpr std::uint64_t times_the_work = 16;
    constexpr double narrow = 0.95;
    NearestPoints& nearest = *answer.nearest;
    if (nearest.lo > narrow * nearest.hi) return;
    const Budget limit(times_the_work * (work_spent() - work_before_));
    const double jump = largest_jump(run_.world().polygons(CurveSide::outer));
    CheckOptions how;
    double share = 0.5;
    for (int k = 0; k < most_margins; ++k, share /= 2) {
      const double margin = nearest.hi * (1 - share);
      // Known margins need not be tested.
      if (!(margin - jump > nearest.lo) || nearest.hi - margin < wanted_width(nearest.hi)) continue;
      how.limits = run_.limits_left();
      if (!keeps(margin, how)) return;
      nearest.lo = (margin - jump) * (1 - 0x1p-50);
    }
  }

  bool keeps(double margin, const CheckOptions& how) const {
    try {
      return check_margins(scene_, PairMargins(margin), how).outcome == Outcome::free;
    } catch (const Interrupted&) {
      return false;
    }
  }

  Clearance with_reason(Clearance answer) const {
    const NearestPoints& nearest = *answer.nearest;
    if (answer.wide.empty()) answer.wide = why_wide(nearest.lo, nearest.hi, options_.relative);
    return answer;
  }

  double wanted_width(double hi) const { return options_.relative * hi + 1e-12 * size_; }

  void note_progress(double width) {
    stalled_ = width > 0.5 * least_width_ ? stalled_ + 1 : 0;
    least_width_ = std::min(least_width_, width);
  }

  bool refine_near(const Clearance& outer, const Clearance& inner, double too_wide) {
    constexpr std::size_t much = 200;
    constexpr int subdivision_threshold = 5;
    Marks marks(run_.world());
    marks.near(outer.nearest->pair, outer.nearest->time.hi, outer.nearest->hi);
    marks.near(inner.nearest->pair, inner.nearest->time.hi, inner.nearest->hi);
    // The nearest points move elsewhere, and to another time, as soon as the curves are refined where they were.
    if (stalled_ > 1) mark_at_all_times(inner, marks);
    if (stalled_ > 1) ++wandered_;
    const std::size_t count = marks.count();
    const bool in_vain = static_cast<double>(count) * std::sqrt(too_wide) > static_cast<double>(most_);
    if (wandered_ > 2 && in_vain) return false;
    // If curves are near for a long time, the number of near cells grows with every halving. If they are near only for
    // a short time, it does not.
    const bool grows = static_cast<double>(count) > 1.3 * static_cast<double>(last_count_);
    last_count_ = count;
    const std::uint64_t segments = run_.world().segments();
    if (count > much && grows && in_vain && segments > most_ / 2) return false;
    return stalled_ < subdivision_threshold && segments < 10 * most_ && run_.refine_beyond_limit(std::move(marks));
  }

  void mark_at_all_times(const Clearance& inner, Marks& marks) const {
    constexpr int times = 32;
    const Scene& scene = run_.world().scene();
    for (int k = 0; k <= times; ++k) {
      const double t = scene.start + (scene.end - scene.start) * (k / static_cast<double>(times));
      marks.near(inner.nearest->pair, t, inner.nearest->hi);
    }
  }

  Clearance concluded(const Clearance& outer, Clearance inner) const {
    inner.nearest->lo = std::min(outer.nearest->lo, inner.nearest->hi);
    if (!(inner.nearest->hi > 0)) return touching_curves(scene_, options_, std::move(inner));
    inner.outcome = inner.nearest->lo > 0 ? Outcome::free : Outcome::undecided;
    inner.geometry->tolerance = name_edges(run_.world(), *inner.nearest);
    return inner;
  }

  const Scene& scene_;
  const ClearanceOptions& options_;
  CurvedRun run_;
  ClearanceOptions own_;
  std::uint64_t most_ = 0, work_before_ = work_spent();
  double size_ = 1;
  int stalled_ = 0, wandered_ = 0;
  std::size_t last_count_ = 0;
  double least_width_ = INFINITY;
};

Clearance least_clearance(const Scene& scene, const ClearanceOptions& options) {
  ClearanceBracket query(scene, options);
  return bracketed(query);
}

/// Converts a pair's answer to the terms of the whole scene.
void place_in(const std::vector<BodyId>& ids, const std::array<BodyId, 2>& pair, NearestPoints& nearest) {
  nearest.pair = pair;
  for (EdgeRef& edge : nearest.edges) edge.body = ids[static_cast<std::size_t>(edge.body)];
}

void name_margin(const CurvedWorld& world, PairMargin& pair) {
  if (pair.nearest) name_edges(world, *pair.nearest);
  if (!pair.features) return;
  world.name_curve(CurveSide::inner, pair.features->vertex);
  if (pair.features->edge) world.name_curve(CurveSide::inner, *pair.features->edge);
  if (pair.features->other) world.name_curve(CurveSide::inner, *pair.features->other);
}

MarginAnswer undecided_margin(MarginAnswer outer, const std::string& reason) {
  outer.outcome = Outcome::undecided;
  outer.reason = reason;
  outer.also.clear();
  if (outer.first) {
    outer.free_until = outer.first->free_until;
    outer.first->outcome = Outcome::undecided;
    outer.first->reason = reason;
    outer.first->features.reset();
    outer.first->nearest.reset();
  }
  return outer;
}

/// Brackets the first time at which bodies come closer than a clearance: marks the parts that make the difference
/// between two runs too wide, and refines them until the answer is found.
class MarginBracket {
 public:
  MarginBracket(const Scene& scene, const PairMargins& margins, const CheckOptions& options)
      : margins_(margins), options_(options), run_(scene, options_.limits) {
    options_.all_pairs = false;
    wanted_ = options_.time_tolerance * (scene.end - scene.start);
  }

  MarginAnswer ask(CurveSide side) const {
    CheckOptions options = options_;
    options.limits = run_.limits_left();
    MarginAnswer answer = check_margins(run_.world().polygons(side), margins_, options);
    answer.geometry = run_.geometry();
    return answer;
  }

  std::optional<MarginAnswer> decided_by(const MarginAnswer& outer) const {
    if (outer.outcome != Outcome::contact && !at_start(outer.outcome)) return outer;
    return std::nullopt;
  }

  std::optional<MarginAnswer> decided_by(const MarginAnswer& outer, const MarginAnswer& inner) const {
    if (inner.outcome == Outcome::undecided) return inner;
    if (say_the_same(outer, inner) && is_narrow(outer, inner)) return concluded(outer, inner);
    return std::nullopt;
  }

  bool refine(const MarginAnswer& outer, const MarginAnswer& inner) {
    Marks marks(run_.world());
    mark(outer, marks);
    mark(inner, marks);
    return run_.refine(std::move(marks));
  }

  MarginAnswer too_fine(MarginAnswer outer, const MarginAnswer&) const {
    return undecided_margin(std::move(outer), "whether curves come closer is finer than doubles resolve, or when");
  }

  CurvedWorld take_world() { return run_.take_world(); }

 private:
  /// If only polygons around the bodies overlap at the start, the bodies are closer all the same.
  static bool say_the_same(const MarginAnswer& outer, const MarginAnswer& inner) {
    return inner.outcome == outer.outcome || (at_start(inner.outcome) && at_start(outer.outcome));
  }

  bool is_narrow(const MarginAnswer& outer, const MarginAnswer& inner) const {
    if (at_start(outer.outcome)) return true;
    const double own = 2 * (inner.first->time.hi - inner.first->time.lo);
    return inner.first->time.hi - outer.first->time.lo <=
           std::max({wanted_, own, 0x1p-49 * std::fabs(inner.first->time.hi)});
  }

  void mark(const MarginAnswer& answer, Marks& marks) const {
    if (!answer.first) return;
    const PairMargin& first = *answer.first;
    const double t = answer.outcome == Outcome::contact ? first.time.hi : run_.world().scene().start;
    marks.near(first.bodies, t, margin_at(first.margin, t));
  }

  MarginAnswer concluded(const MarginAnswer& outer, MarginAnswer inner) const {
    if (inner.outcome == Outcome::contact) {
      inner.first->time.lo = outer.first->time.lo;
      inner.first->free_until = inner.free_until = outer.first->time.lo;
    }
    name_margin(run_.world(), *inner.first);
    for (PairMargin& pair : inner.also) name_margin(run_.world(), pair);
    return inner;
  }

  const PairMargins& margins_;
  CheckOptions options_;
  CurvedRun run_;
  double wanted_ = 0;
};

}  // namespace

double largest_size(const CurvedWorld& world) {
  double size = 0;
  for (std::size_t i = 0; i < world.scene().bodies.size(); ++i) {
    for (const curve::BandedPart& part : world.parts(static_cast<BodyId>(i)))
      size = std::max(size, part.bands()[0].resolution().size);
  }
  return size;
}

Clearance clearance_of_curves(const Scene& scene, const ClearanceOptions& options) {
  Clearance answer = least_clearance(scene, options);
  if (!options.all_pairs || !answer.reason.empty()) return answer;
  // Polygons around the bodies are no farther apart than these.
  ClearanceOptions coarse = options;
  coarse.relative = 0.1;
  const Clearance pairs = clearance(CurvedWorld(scene).polygons(CurveSide::outer), coarse);
  if (!pairs.reason.empty()) answer.reason = pairs.reason;
  for (const NearestPoints& pair : pairs.pairs) {
    std::vector<BodyId> ids;
    const Scene small = scene_of_pair(scene, pair.pair, ids);
    ClearanceOptions own = options;
    own.all_pairs = false;
    own.within = ClearanceOptions{}.within;
    const Clearance found = has_curves(small) ? least_clearance(small, own) : clearance(small, own);
    if (!found.reason.empty()) answer.reason = found.reason;
    if (!found.wide.empty()) answer.wide = found.wide;
    if (!found.nearest) continue;
    if (found.nearest->lo > options.within) continue;
    answer.pairs.push_back(*found.nearest);
    place_in(ids, pair.pair, answer.pairs.back());
  }
  return answer;
}

CurvedMargin margin_of_curves(const Scene& scene, const PairMargins& margins, const CheckOptions& options) {
  MarginBracket bracket(scene, margins, options);
  MarginAnswer answer = bracketed(bracket);
  return {std::move(answer), bracket.take_world()};
}

MarginAnswer check_margins_of_curves(const Scene& scene, const PairMargins& margins, const CheckOptions& options) {
  MarginAnswer answer = margin_of_curves(scene, margins, options).answer;
  if (!options.all_pairs) return answer;
  CheckOptions all = options;
  const MarginAnswer pairs = check_margins(CurvedWorld(scene).polygons(CurveSide::outer), margins, all);
  all.all_pairs = false;
  for (PairMargin pair : pairs.pairs) {
    if (pair.outcome != Outcome::free) {
      std::vector<BodyId> ids;
      const Scene small = scene_of_pair(scene, pair.bodies, ids);
      const PairMargins only(pair.margin);
      const MarginAnswer own = check_margins(small, only, all);
      PairMargin found = own.first.value_or(PairMargin{});
      found.margin = pair.margin;
      found.margin_at = margin_at(pair.margin, own.outcome == Outcome::contact ? found.time.hi : own.free_until);
      found.bodies = pair.bodies;
      found.outcome = own.outcome;
      found.free_until = own.free_until;
      found.reason = own.reason;
      if (found.nearest) place_in(ids, pair.bodies, *found.nearest);
      const auto place = [&](auto& feature) { feature.body = ids[static_cast<std::size_t>(feature.body)]; };
      if (found.features) {
        place(found.features->vertex);
        if (found.features->edge) place(*found.features->edge);
        if (found.features->other) place(*found.features->other);
      }
      pair = found;
    }
    answer.pairs.push_back(pair);
  }
  return answer;
}

}  // namespace taut::internal
