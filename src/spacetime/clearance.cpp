#include "spacetime/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numeric/budget.hpp"
#include "spacetime/margin.hpp"
#include "spacetime/stretch.hpp"
#include "spacetime/walk.hpp"
#include "taut/check.hpp"

namespace taut::internal::spacetime {
namespace {

/// In stretches shorter than this share of the segment, errors have become as small as they get.
constexpr double shortest_of_clearance = 0x1p-30;
/// Stretches are not divided any more when they are this short.
constexpr double shortest_of_all = 0x1p-60;
/// An error that is no more than this share of all lengths is that of rounding, and does not shrink with the stretch.
constexpr double error_of_rounding = 0x1p-42;
/// Nor does one of which the part that shrinks (Stretch::rest) is no more than this share. That part counts turns once,
/// where the error counts them up to some ten times. On a bridge it is zero: all of the error is rounding.
constexpr double share_that_shrinks = 0x1p-5;

/// After so many evaluations of an edge of each body the walk gives up. A pin that turns in its bore shows each of its
/// edges to each of the bore's: a few evaluations of each pair are no sign of steps that are too short.
std::uint64_t most_leaf_looks(const PairGeometry& g) {
  constexpr std::uint64_t at_least = 20000, of_pair = 4, at_most = 1 << 23;
  return at_least + std::min(of_pair * g.np * g.nq, at_most);
}

/// Where are the bodies nearest on one segment: what the walk asks. Where two edges keep nearly the least distance for
/// long, steps are as short as the root of the tolerance, and there may be millions of them. Then it gives up: nothing
/// is certain from below, until a margin is asked for (resolve_nearest()), by functions that are followed to their
/// roots.
class ClearanceOnSegment {
 public:
  ClearanceOnSegment(const PairGeometry& geometry, const MotionSegment& segment, std::size_t index,
                     const ClearanceTolerance& tolerance, Nearest& best)
      : shortest(shortest_of_all * (segment.end - segment.start)),
        geometry_(geometry),
        index_(index),
        tolerance_(tolerance),
        best_(best),
        looks_left_(most_leaf_looks(geometry)) {}

  static constexpr bool nearer_first = true;  ///< it may spare the other
  const double shortest;
  double distance_of_interest() const { return tolerance_.least(best_.distance); }
  bool begins(double) const { return true; }
  BoxDecision evaluate(const StretchOfTime& time, const BoxNode& p, const BoxNode& q) {
    if (looks_left_ == 0) return BoxDecision::done;
    const Stretch& s = time.bounds;
    const bool leaf = p.count == 1 && q.count == 1;
    const Path relative = s.in_p.place(q.box.centre, p.box.centre);
    Vector towards{relative.x.a, relative.y.a};
    if (leaf) towards = measure(s, VertexId(p.first), VertexId(geometry_.np + q.first));
    if (farther(s, p.box, q.box, towards, tolerance_.least(best_.distance))) return BoxDecision::done;
    if (!leaf && motion(s, p.box, q.box) <= subdivision_threshold * (p.box.radius + q.box.radius))
      return BoxDecision::divided;
    if (leaf && is_resolved(time, p.box, q.box, towards)) return BoxDecision::done;
    if (time.divisible && !(leaf && --looks_left_ == 0)) return BoxDecision::deferred;
    if (!leaf && looks_left_ > 0 && best_.unresolved > 0) return BoxDecision::divided;
    best_.unresolved = 0;
    return BoxDecision::done;
  }

 private:
  /// Are the bounds of doubles all that keeps the two from being farther apart than the tolerance wants? Then still
  /// shorter stretches would not help, and what is certain is noted. Neither would they where next to nothing moves: on
  /// a bridge, say, all over which bodies may nearly touch. Nor where the tolerance is less than doubles resolve:
  /// bodies that slide on each other, a little apart, would be followed by steps as short as that.
  bool is_resolved(const StretchOfTime& time, const Box& p, const Box& q, Vector towards) {
    const Stretch& s = time.bounds;
    const double error = s.in_p.error;
    const bool is_short = s.r <= shortest_of_clearance * time.scale;
    const bool is_rounding = error <= error_of_rounding * s.in_p.reach;
    const bool beyond_doubles =
        s.rest <= share_that_shrinks * error && best_.distance - tolerance_.least(best_.distance) <= error;
    if (!is_short && !beyond_doubles && !(is_rounding && motion(s, p, q) <= error)) return false;
    for (const double errors : {1, 2, 4, 8}) {
      const double margin = tolerance_.least(best_.distance) - errors * error;
      if (!farther(s, p, q, towards, margin)) continue;
      best_.unresolved = std::min(best_.unresolved, std::max(0.0, margin));
      return true;
    }
    return false;
  }
  /// The distance of two edges in the middle of the stretch; the direction of the shortest connection, in P's frame.
  Vector measure(const Stretch& s, VertexId of_p, VertexId of_q) {
    const auto point = [&](VertexId v) { return Vector{geometry_.point(v).x, geometry_.point(v).y}; };
    const auto placed = [&](VertexId v) {
      const Path path = s.in_p.place(point(v), {0, 0});
      return Vector{path.x.a, path.y.a};
    };
    const Closest found =
        Closest::of(point(of_p), point(geometry_.next(of_p)), placed(of_q), placed(geometry_.next(of_q)));
    // No direction is wrong by more than the stretch's error, so neither is the distance.
    const double distance = found.distance * (1 + 0x1p-48) + s.in_p.error;
    if (distance < best_.distance) best_ = {distance, index_, s.middle, of_p, of_q, best_.unresolved};
    return found.on_q - found.on_p;
  }

  const PairGeometry& geometry_;
  std::size_t index_;
  ClearanceTolerance tolerance_;
  Nearest& best_;
  std::uint64_t looks_left_;
};

/// An instant, if the window is one.
void search_segment(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                    std::size_t index, const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best) {
  const std::shared_ptr<const MotionSegment> held = segments.hold(index);
  const MotionSegment& segment = *held;
  ClearanceOnSegment question(geometry, segment, index, tolerance, best);
  Walk<ClearanceOnSegment> walk(trees, segment, question);
  if (window.lo < window.hi) return walk.through(window.lo, window.hi);
  walk.at(window.lo);
}

}  // namespace

void find_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments, double until,
                  const ClearanceTolerance& tolerance, Nearest& best) {
  for (std::size_t i = 0; i < segments.size() && segments.place(i).start <= until; ++i) {
    const SegmentPlace at = segments.place(i);
    const TimeInterval whole = at.bridge ? TimeInterval{0, 1} : TimeInterval{at.start, std::min(at.end, until)};
    search_segment(geometry, trees, segments, i, whole, tolerance, best);
  }
}

void find_nearest_within(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                         double from, double to, const ClearanceTolerance& tolerance, Nearest& best) {
  for (std::size_t i = segments.first_until(from); i < segments.size(); ++i) {
    const SegmentPlace at = segments.place(i);
    if (at.start > to) break;
    const TimeInterval window{std::max(from, at.start), std::min(to, at.end)};
    if (!at.bridge && window.lo <= window.hi) search_segment(geometry, trees, segments, i, window, tolerance, best);
  }
}

void find_nearest_in_middle(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment,
                            const Stretch& stretch, const ClearanceTolerance& tolerance, Nearest& best) {
  ClearanceOnSegment question(geometry, segment, 0, tolerance, best);
  Walk<ClearanceOnSegment>(trees, segment, question).in_middle_of(stretch);
}

namespace {

/// Covers the rounding of the few operations on the data of a stretch, and of its directions' lengths.
constexpr double rounded_up = 1 + 0x1p-40;

/// Where bodies rotate, a stretch is evaluated in parts that are at most this long: its bound is an upper end that
/// users see.
constexpr double longest_share = 0.125;

/// The bound for a moving vertex and a resting edge, in the edge's frame.
double vertex_bound(const RelativePose& relative_pose, double r, Vector vertex, Vector from, Vector to) {
  const Vector relative = to - from;
  const double length = std::sqrt(dot(relative, relative));
  const Vector e{relative.x / length, relative.y / length};
  const Path path = relative_pose.place(vertex, from);
  const Parabola along_edge = along(e, path), across = along(turned(e), path);
  const double before = -along_edge.least(r), behind = -(-along_edge).least(r) - length;
  const double across_by = std::max(-across.least(r), -(-across).least(r));
  const double past = std::max({0.0, before, behind}) + relative_pose.error, off = across_by + relative_pose.error;
  return std::sqrt(past * past + off * off) * rounded_up + length * 0x1p-45;
}

class PieceBound {
 public:
  PieceBound(const PairGeometry& geometry, const TreePair& trees, const ClearanceTolerance& tolerance)
      : geometry_(geometry), trees_(trees), tolerance_(tolerance) {}

  /// The bound for the edges that are nearest in the middle of the stretch.
  double of(const MotionSegment& segment, const Stretch& s) const {
    Nearest nearest;
    nearest.distance = INFINITY;
    find_nearest_in_middle(geometry_, trees_, segment, s, tolerance_, nearest);
    if (!(nearest.distance < INFINITY)) return INFINITY;
    const Vector a = point(nearest.edge_p), b = point(geometry_.next(nearest.edge_p));
    const Vector c = point(nearest.edge_q), d = point(geometry_.next(nearest.edge_q));
    return std::min({vertex_bound(s.in_p, s.r, c, a, b), vertex_bound(s.in_p, s.r, d, a, b),
                     vertex_bound(s.in_q, s.r, a, c, d), vertex_bound(s.in_q, s.r, b, c, d)});
  }

 private:
  Vector point(VertexId v) const { return {geometry_.point(v).x, geometry_.point(v).y}; }

  const PairGeometry& geometry_;
  const TreePair& trees_;
  const ClearanceTolerance& tolerance_;
};

double bound_on_segment(const PieceBound& piece, const MotionSegment& segment, double from, double to) {
  if (segment.translation)
    return piece.of(segment, Stretch::of_translation(segment, TranslationPolynomial(segment), from, to));
  const double longest = (to - from) * longest_share;
  double most = 0, length = longest;
  for (double t = from; t < to;) {
    checkpoint();
    FrameWindow window(segment, t, to, length);
    const double end = window.end();
    const Stretch s =
        window.smooth() ? Stretch::of_window(segment, window, t, end) : Stretch::of_range(segment, window);
    most = std::max(most, piece.of(segment, s));
    length = std::min(longest, window.fitting_length());
    t = end;
  }
  return most;
}

}  // namespace

double distance_bound(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments, double from,
                      double to, const ClearanceTolerance& tolerance) {
  const PieceBound piece(geometry, trees, tolerance);
  double most = 0;
  for (std::size_t i = segments.first_until(from); i < segments.size(); ++i) {
    const SegmentPlace at = segments.place(i);
    if (at.start > to) break;
    const double start = std::max(from, at.start), end = std::min(to, at.end);
    if (!at.bridge && start < end) most = std::max(most, bound_on_segment(piece, *segments.hold(i), start, end));
  }
  return most;
}

namespace {

/// From zero, this many halvings pass all margins that differ in the scale of the scene.
constexpr int most_halvings = 120;

/// Stores the features that come as close as the margin as the nearest found so far.
void take_approach(const PairGeometry& geometry, const MarginResult& found, double margin, Nearest& best) {
  const bool first = geometry.in_p(found.pair.vertex);
  best.distance = margin;
  best.segment = found.segment;
  best.parameter = found.hi;
  best.edge_p = first ? found.pair.vertex : found.pair.peer;
  best.edge_q = first ? found.pair.peer : found.pair.vertex;
}

/// Lowers the least distance to its value at some instants. Each evaluation costs far less than a query about a margin.
/// Such a query shows only that a margin is not kept, and each such answer halves the gap.
class Evaluations {
 public:
  Evaluations(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
              const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best)
      : geometry_(geometry), trees_(trees), segments_(segments), window_(window), tolerance_(tolerance), best_(best) {}

  /// Evaluates where bodies rotate with infinite speed. The features that are nearest there need not be nearest a
  /// rounding error away.
  void at_singular_ends() {
    for (std::size_t i = segments_.first_until(window_.lo); i < segments_.size(); ++i) {
      const SegmentPlace place = segments_.place(i);
      if (place.start > window_.hi) break;
      if (place.bridge) continue;
      const std::shared_ptr<const MotionSegment> segment = segments_.hold(i);
      for (const double t : {segment->start, segment->end}) {
        if (segment->singular_at(t)) at(*segment, i, t);
      }
    }
  }
  /// Evaluates where they come closer than a margin, and then at instants farther and farther from there.
  void after(const MarginResult& found) {
    const SegmentPlace place = segments_.place(found.segment);
    if (place.bridge) return;
    const std::shared_ptr<const MotionSegment> segment = segments_.hold(found.segment);
    const double time_ahead = std::fmin(place.end, window_.hi) - found.hi;
    for (double share = 1; time_ahead > 0 && share > 0x1p-40; share /= 4)
      at(*segment, found.segment, found.hi + time_ahead * share);
  }

 private:
  void at(const MotionSegment& segment, std::size_t index, double t) {
    if (!(t >= std::fmax(segment.start, window_.lo) && t <= std::fmin(segment.end, window_.hi))) return;
    checkpoint();
    Nearest there = best_;
    find_nearest_in_middle(geometry_, trees_, segment, Stretch::at_instant(segment, t), tolerance_, there);
    if (!(there.distance < best_.distance)) return;
    there.segment = index;
    there.unresolved = best_.unresolved;  // which refers to the whole window
    best_ = there;
  }

  const PairGeometry& geometry_;
  const TreePair& trees_;
  const MotionSegments& segments_;
  TimeInterval window_;
  ClearanceTolerance tolerance_;
  Nearest& best_;
};

}  // namespace

std::string resolve_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                            const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best) {
  double certain = best.unresolved;
  Evaluations evaluations(geometry, trees, segments, window, tolerance, best);
  if (certain < tolerance.least(best.distance)) evaluations.at_singular_ends();
  // Most often doubles have found the least distance, or nearly so, and only the lower bound is missing. So the bound
  // is searched for at growing distances below the value found, not halfway down to zero.
  double margin = tolerance.least(best.distance), below = best.distance - margin;
  for (int step = 0; certain < tolerance.least(best.distance); ++step) {
    checkpoint();
    if (!(margin > certain && margin < best.distance) || step == most_halvings)
      return "doubles do not resolve the distance further";
    const MarginResult found = first_closer(geometry, trees, segments, constant_margin(margin), window);
    if (found.outcome == MarginResult::undecided) return found.reason;
    if (found.outcome == MarginResult::free) {
      best.unresolved = certain = margin;
    } else {
      take_approach(geometry, found, margin, best);
      evaluations.after(found);
      below *= 8;
    }
    const double halfway = certain + (best.distance - certain) / 2;
    margin = std::fmin(tolerance.least(best.distance), std::fmax(halfway, best.distance - below));
  }
  best.unresolved = INFINITY;
  return {};
}

}  // namespace taut::internal::spacetime
