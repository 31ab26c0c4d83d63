#include "spacetime/clearance.hpp"

#include <algorithm>
#include <optional>

#include "numeric/budget.hpp"
#include "spacetime/stretch.hpp"

namespace taut::internal::spacetime {
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

}  // namespace taut::internal::spacetime
