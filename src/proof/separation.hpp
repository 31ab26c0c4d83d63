// What keeps two ranges of edges, or two edges, apart over a window of time: the steps of a log of separations.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "certificate/taylor_frames.hpp"
#include "proof/edge_ranges.hpp"
#include "proof/lifetime.hpp"
#include "proof/motion_window.hpp"

namespace taut::internal::proof {

/// One byte for each step on the way down: docs/proof-format.md.
namespace step {
inline constexpr std::uint8_t halve_time = 0, halve_p = 1, halve_q = 2;
/// Two edges, of which neither end of one meets the other: a byte with what keeps them apart follows.
inline constexpr std::uint8_t ends_apart = 3;
/// The window is after the contact.
inline constexpr std::uint8_t later = 4;
/// A direction separates the two ranges: one of four along P's rectangle, then Q's, then 64 in P's frame.
inline constexpr std::uint8_t along_p = 8, along_q = 12, direction = 64, directions = 64;
}  // namespace step

/// Why a vertex does not meet an edge. The first four are of the edge itself: on which side of its line the vertex
/// stays, or that it is behind one of its ends. Where a vertex comes to a vertex, all of these may change at once, and
/// a line next to them shows more: that of the edge before or after, which has the edge on its one side and the vertex
/// on the other; or that of an edge at the vertex, which has all of the edge on one side. The last one is for corners
/// that pass each other between two doubles.
enum class SeparationReason : std::uint8_t {
  left,
  right,
  behind_first,
  behind_second,
  beyond_line_before,
  beyond_line_after,
  right_of_arriving,
  right_of_leaving,
  left_of_arriving,
  left_of_leaving,
  behind_when_on_line,  ///< it crosses the line, and is behind one of the edge's ends whenever it does
};
inline constexpr int reasons = 11;

/// A form that keeps its sign.
struct KeptFunction {
  CertificateFunction function;
  int sign = 0;
};

/// A vertex of one body and an edge of the other, by its first vertex.
struct Incidence {
  VertexId vertex, edge;

  CertificateFunction line(const PairGeometry& g) const { return {edge, g.next(edge), vertex, g.in_p(edge)}; }
};

/// Where a vertex is in its body's frame, without the displacement.
inline Vector place(const PairGeometry& g, VertexId v) { return {g.point(v).x, g.point(v).y}; }

/// Where a vertex is that stays off the edge from a to b for one of the first four reasons: the points from which
/// the way to it has a positive product with the normal.
struct HalfPlane {
  Vector normal, from;
};
HalfPlane half_plane(Vector a, Vector b, SeparationReason why);

/// The forms that keep their signs, for that reason; none where it is no reason for this edge. One or two.
struct KeptFunctions {
  std::array<KeptFunction, 2> functions;
  int count = 0;
};
KeptFunctions kept_functions(const PairGeometry& geometry, const Incidence& incidence, SeparationReason why);

/// Does the vertex stay off it, for that reason, over all of [from, until]? Where a form is that of `until`, not at
/// that very instant: there the vertex has come to the other edge. Throws Undecidable.
bool stays_separated(const PairGeometry& geometry, Lifetimes& lifetimes, const Incidence& incidence,
                     SeparationReason why, double from, const Instant& until);
/// The same for one of the first four reasons, as far as the motion's second order over the window shows.
enum class SeparationInWindow : std::uint8_t {
  yes,
  no,    ///< in the middle of the window it is on the other side
  open,  ///< shorter windows may show more
  even,  ///< nor they: all over the window, it is on neither side by more than rounding
};
SeparationInWindow stays_separated_in_window(const PairGeometry& geometry, const Incidence& incidence,
                                             SeparationReason why, const MotionWindow& window);
/// The same for any of them, as far as doubles show.
bool stays_separated_in_doubles(const PairGeometry& geometry, Lifetimes& lifetimes, const Incidence& incidence,
                                SeparationReason why, double from, const Instant& until);

/// Two ranges of edges by their numbers in their bodies' trees.
struct RangePair {
  std::uint32_t p = EdgeRanges::all, q = EdgeRanges::all;

  bool is_whole() const { return p == EdgeRanges::all && q == EdgeRanges::all; }
};

/// One pair of bodies, with their ranges of edges.
struct RangedPair {
  const PairGeometry& geometry;
  const EdgeRanges &p, &q;

  bool single(const RangePair& r) const { return p[r.p].single() && q[r.q].single(); }
  /// Each edge stands for its first vertex: the vertex that may meet the other edge, of Q and of P.
  Incidence onto_p(const RangePair& r) const { return {VertexId(geometry.np + q[r.q].first), VertexId(p[r.p].first)}; }
  Incidence onto_q(const RangePair& r) const { return {VertexId(p[r.p].first), VertexId(geometry.np + q[r.q].first)}; }
};

/// Does the direction that a step names certainly have all of one range beyond all of the other, by more than a margin,
/// all over the window?
bool separates(std::uint8_t named, const MotionWindow& window, const EdgeRange& p, const EdgeRange& q,
               double margin = 0);

/// The step whose direction does, or nothing: the sides of both rectangles are tried, and the direction between the
/// centres.
std::optional<std::uint8_t> separating_step(const MotionWindow& window, const EdgeRange& p, const EdgeRange& q,
                                            double margin = 0);

/// About how far the ranges move relative to each other within the window.
double motion_in(const MotionWindow& window, const EdgeRange& q);

// Features of two bodies that stay farther apart than a margin over a stretch of a segment.

/// Two bodies that do not overlap are closer than a margin only if two of their vertices are, or if a vertex is that
/// close in front of an edge onto which it projects. So of two edges, each of which stands for its first vertex, three
/// things are to be shown: the two vertices, and each vertex and the other edge.
class KeptMargin {
 public:
  /// The margin is in internal units, and positive. The segment is no bridge.
  KeptMargin(const RangedPair& pair, const MotionSegment& segment, double margin)
      : pair_(pair), segment_(segment), margin_(margin) {}

  /// Are the first vertices of both edges farther apart, at all times of [from, to]?
  bool vertices(const RangePair& edges, double from, double to) const;
  /// Is a vertex farther from the edge all over [from, to], for that reason: in front of its line by more than the
  /// margin (SeparationReason::right), behind it (left), or behind one of its ends? Others are no reasons here.
  bool separated(Lifetimes& lifetimes, const Incidence& incidence, SeparationReason why, double from, double to) const;

 private:
  const RangedPair& pair_;
  const MotionSegment& segment_;
  double margin_;
  mutable TaylorFrames models_;  ///< of the segment, for all that is asked
};

/// Is the incidence's vertex certainly closer than the margin to the edge, or to the other vertex, at that parameter?
bool closer_at(const PairGeometry& geometry, const MotionSegment& segment, double margin, const Incidence& pair,
               bool is_edge, const FineInstant& at);

}  // namespace taut::internal::proof
