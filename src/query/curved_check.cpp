// The first contact of bodies with curves, and the check of each pair and of shrunk bodies.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "query/bracket.hpp"
#include "scene/fitted_scene.hpp"
#include "scene/instance.hpp"
#include "solver/earliest.hpp"
#include "solver/run.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

using SteadyClock = std::chrono::steady_clock;

std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", x);
  return text;
}

const char* const remedies =
    "; `--fit E` asks about bodies that are shrunk by a little, and `taut clearance` how close they come";

/// The pair of an answer.
std::array<BodyId, 2> pair_in(const Answer& answer) { return answer.pair.value_or(std::array<BodyId, 2>{0, 1}); }

/// Brackets one first contact.
class CurvedCheck {
 public:
  CurvedCheck(const Scene& scene, const CheckOptions& options)
      : options_(options), run_(scene, options.limits), from_(scene.start) {
    wanted_ = options.time_tolerance * (scene.end - scene.start);
  }

  Answer run() {
    for (int round = 0;; ++round) {
      const Answer outer = ask(CurveSide::outer, from_, run_.world().scene().end);
      if (outer.outcome == Outcome::untested) return outer;
      if (outer.outcome == Outcome::free || outer.outcome == Outcome::undecided) return concluded(outer, {});
      if (outer.outcome == Outcome::overlap_at_start) {
        if (auto answer = begin_together(outer)) return *answer;
        continue;
      }
      if (auto answer = bracket(outer, round)) return *answer;
    }
  }

  CurvedWorld take_world() { return run_.take_world(); }

 private:
  Answer ask(CurveSide side, double from, double to) {
    CheckOptions options = options_;
    options.tell_touching = false;
    options.limits = run_.limits_left();
    Scene scene = run_.world().polygons(side);
    take_time(scene, from, to);
    const Answer answer = check(scene, options);
    events_ += answer.events;
    return answer;
  }

  /// The same pairs are asked about in a part of the time, even if nothing moves in it.
  void take_time(Scene& scene, double from, double to) {
    if (from == scene.start && to == scene.end) return;
    if (!at_rest_) at_rest_ = Instance(scene).at_rest();
    scene.at_rest = *at_rest_;
    scene.start = from;
    scene.end = to;
  }

  /// Polygons around the bodies overlap at the beginning of the time.
  std::optional<Answer> begin_together(const Answer& outer) {
    if (from_ > run_.world().scene().start) {
      // This is due to the displacement: bodies that were free before, by less than it, need not be free to the last
      // bit.
      from_ = run_.world().scene().start;
      windows_ = false;
      return std::nullopt;
    }
    const Answer inner = ask(CurveSide::inner, from_, from_);
    if (inner.outcome == Outcome::overlap_at_start) return concluded(inner, {});
    Marks marks(run_.world());
    marks.near(pair_in(outer), from_);
    if (!is_hopeless(outer, from_, marks.count()) && run_.refine(std::move(marks))) return std::nullopt;
    return undecided(outer,
                     "curves touch or run along each other at the start: whether they overlap is finer than "
                     "polygons resolve");
  }

  std::optional<Answer> bracket(const Answer& outer, int round) {
    const double lo = outer.contact->time.lo;
    Marks marks(run_.world());
    marks.near(pair_in(outer), lo);
    const bool still = round > 0 && lo - last_ <= 64 * wanted_;
    last_ = lo;
    // Where polygons meet again and again at other places, as those of a pin that turns in its bore, all of the curves
    // is as coarse as what is near at one of the instants.
    constexpr int often = 8;
    if (!still && round % often == often - 1) marks.as_thick(pair_in(outer));
    std::optional<Answer> inner;
    if (still || marks.count() == 0 || run_.at_limit()) {
      inner = ask(CurveSide::inner, from_, run_.world().scene().end);
      if (inner->outcome == Outcome::undecided) return concluded(*inner, lo);
      if (inner->contact && inner->contact->time.hi - lo <= width_of(*inner->contact)) return contact(outer, *inner);
      if (inner->contact) marks.near(pair_in(*inner), inner->contact->time.hi);
    }
    if (is_hopeless(outer, lo, marks.count()) || !run_.refine(std::move(marks))) {
      if (inner && inner->contact) return barely(outer, *inner);
      return undecided(outer,
                       "from t = " + short_text(lo) +
                           " on curves touch, or come nearer to it than doubles resolve, and may not overlap at all");
    }
    if (windows_) from_ = std::max(from_, lo - wanted_);
    return std::nullopt;
  }

  /// If many cells are near, the curves may coincide along a length. Refinement would then reach the limit in vain.
  bool is_hopeless(const Answer& outer, double t, std::size_t count) const {
    constexpr std::size_t much = 200;
    return count > much && run_along(run_.world(), pair_in(outer), t, run_.most_segments());
  }

  /// The uncertainty of the answers for the polygons themselves is not due to the curves.
  double width_of(const Contact& contact) const {
    return std::max({wanted_, 2 * (contact.time.hi - contact.time.lo), 0x1p-49 * std::fabs(contact.time.hi)});
  }

  Answer contact(const Answer& outer, Answer inner) const {
    inner.contact->time.lo = outer.contact->time.lo;
    inner.contact->grazing = inner.contact->grazing || outer.contact->grazing;
    inner.free_until = outer.contact->time.lo;
    return concluded(inner, outer.contact->time.lo);
  }

  /// The resolution of doubles was reached before the bracket was narrow enough.
  Answer barely(const Answer& outer, const Answer& inner) const {
    return undecided(outer, "they overlap first between t = " + short_text(outer.contact->time.lo) + " and t = " +
                                short_text(inner.contact->time.hi) + ", and doubles cannot resolve curves further");
  }

  Answer undecided(const Answer& outer, const std::string& reason) const {
    Answer answer = outer;
    answer.outcome = Outcome::undecided;
    answer.free_until = outer.contact ? outer.contact->time.lo : run_.world().scene().start;
    answer.contact.reset();
    answer.overlap_point.reset();
    answer.also.clear();
    answer.reason = reason + remedies;
    return concluded(answer, answer.free_until);
  }

  Answer concluded(Answer answer, std::optional<double> free_until) const {
    CurveGeometry geometry{answer.outcome == Outcome::free ? run_.world().tolerance() : 0, run_.world().segments()};
    if (answer.contact) geometry.tolerance = run_.world().name_curves(CurveSide::inner, *answer.contact);
    for (PairAnswer& pair : answer.also) {
      if (pair.contact) run_.world().name_curves(CurveSide::inner, *pair.contact);
    }
    if (free_until) answer.free_until = std::max(answer.free_until, *free_until);
    if (answer.outcome == Outcome::undecided || answer.outcome == Outcome::overlap_at_start)
      geometry.tolerance = run_.world().tolerance();
    answer.geometry = geometry;
    answer.events = events_;
    answer.run_seconds = run_.seconds() - answer.build_seconds;
    return answer;
  }

  const CheckOptions& options_;
  CurvedRun run_;
  std::optional<AtRest> at_rest_;  ///< of parts of the time
  double from_;                    ///< nothing happens before this time
  double wanted_ = 0;
  double last_ = 0;
  bool windows_ = true;
  std::uint64_t events_ = 0;
};

Answer check_curved_or_plain(const Scene& scene, const CheckOptions& options) {
  return has_curves(scene) ? CurvedCheck(scene, options).run() : check(scene, options);
}

/// Checks each pair separately. Pairs whose outer polygons never meet are decided together, the others one by one.
Answer check_each_pair(const Scene& scene, const CheckOptions& options) {
  const SteadyClock::time_point began = SteadyClock::now();
  CurvedWorld world(scene);
  CheckOptions all = options;
  all.tell_touching = false;
  Answer answer = check(world.polygons(CurveSide::outer), all);
  if (answer.outcome == Outcome::untested) return answer;
  answer.geometry = CurveGeometry{world.tolerance(), world.segments()};
  if (!answer.pairs) return answer;
  all.all_pairs = false;
  std::vector<PairEvent> events;
  double tolerance = 0;
  for (PairAnswer& pair : *answer.pairs) {
    if (pair.outcome == Outcome::free) continue;
    std::vector<BodyId> ids;
    all.limits.max_seconds = time_left(options.limits.max_seconds, began);
    const Answer own = check_curved_or_plain(scene_of_pair(scene, pair.bodies, ids), all);
    pair = {pair.bodies, own.outcome, own.contact, own.outcome == Outcome::free ? scene.end : own.free_until,
            own.reason};
    if (own.geometry) tolerance = std::max(tolerance, own.geometry->tolerance);
    if (pair.contact) {
      for (BodyId* id : {&pair.contact->vertex.body, &pair.contact->edge.body})
        *id = ids[static_cast<std::size_t>(*id)];
    }
    if (pair.outcome != Outcome::free) events.push_back({pair, {}});
  }
  answer.outcome = Outcome::free;
  answer.contact.reset();
  answer.pair.reset();
  answer.also.clear();
  answer.reason.clear();
  answer.free_until = scene.end;
  take_earliest(events, answer);
  if (answer.outcome != Outcome::free) answer.geometry->tolerance = tolerance;
  return answer;
}

/// Checks bodies that are shrunk: polygons that are fine compared to that suffice.
Answer check_fitted_curves(const Scene& scene, CheckOptions options) {
  CurvedWorld world(scene);
  const double fit = options.fit;
  if (!(fit > 0 && std::isfinite(fit))) throw InputError("fit", "it is not a positive number", "leave it out");
  const double tolerance = fit / 8;
  world.refine_to(tolerance);
  // Where parts of a body touch along a curve, the polygons around them overlap, and those within them leave a gap.
  const bool may_touch =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) { return body.curves.size() > 1; });
  const CurveSide side = may_touch ? CurveSide::outer : CurveSide::inner;
  options.fit = 0;
  options.tell_touching = false;
  const FittedScene fitted(world.polygons(side), fit, may_touch ? tolerance : 0);
  Answer answer = check(fitted.scene(), options);
  fitted.name_given(answer);
  answer.fit = fit;
  answer.geometry = CurveGeometry{world.tolerance(), world.segments()};
  if (answer.contact) world.name_curves(side, *answer.contact);
  for (PairAnswer& pair : answer.also) {
    if (pair.contact) world.name_curves(side, *pair.contact);
  }
  if (answer.pairs) {
    for (PairAnswer& pair : *answer.pairs) {
      if (pair.contact) world.name_curves(side, *pair.contact);
    }
  }
  return answer;
}

}  // namespace

CurvedContact first_contact_of_curves(const Scene& scene, const CheckOptions& options) {
  CurvedCheck check(scene, options);
  Answer answer = check.run();
  return {std::move(answer), check.take_world()};
}

Answer check_curved(const Scene& scene, const CheckOptions& options) {
  if (options.fit != 0) return check_fitted_curves(scene, options);
  if (options.all_pairs) return check_each_pair(scene, options);
  return CurvedCheck(scene, options).run();
}

}  // namespace taut::internal
