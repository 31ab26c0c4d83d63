// A vertex that crosses an edge: the roots that may be contacts, at any precision.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "certificate/precise_triple.hpp"
#include "numeric/errors.hpp"

namespace taut::internal::spacetime {

/// A vertex of one body and an edge of the other, given by its first vertex.
struct VertexEdge {
  VertexId vertex, edge;

  /// The side of the edge's line on which the vertex is, and its position along the line from the first end and from
  /// the second.
  CertificateFunction line(const PairGeometry& g) const { return {edge, g.next(edge), vertex, g.in_p(edge)}; }
  CertificateFunction from_start(const PairGeometry& g) const { return line(g).along(); }
  CertificateFunction from_end(const PairGeometry& g) const { return line(g).back(); }

  std::uint64_t number() const { return std::uint64_t{vertex.value} << 32 | edge.value; }
};

/// An instant at which the vertex passes through the edge, from outside to inside unless `out`. It is the only instant
/// in [lo, hi] at which the vertex is on the edge's line.
struct Crossing {
  VertexEdge pair;
  bool out = false;
  double lo = 0, hi = 0;
  std::optional<PreciseTime>
      precise;  ///< within [lo, hi], where there may be another root; set once a stage has refined it
};

/// The crossings to search for: those that may be first contacts, or all.
enum class CrossingDirections : unsigned char { into, both };

/// Does the vertex project onto the edge, or is it beyond one of its ends?
enum class OnEdge : unsigned char { yes, no, unknown };

/// The precise stages for one segment. All members throw Undecidable where the last stage does not suffice.
class PreciseCrossings {
 public:
  PreciseCrossings(const PairGeometry& geometry, const MotionSegment& segment, CrossingDirections directions)
      : geometry_(geometry), segment_(segment), directions_(directions) {
    memory_.reset(segment);
  }

  /// The side of the edge's line on which the vertex is.
  int side(const VertexEdge& pair, double t);
  /// The first crossing in (from, to].
  std::optional<Crossing> first(const VertexEdge& pair, double from, double to);
  /// Does the vertex project onto the edge at this root of the orientation, whose sign changes from `sign`? The root
  /// need not be a crossing.
  OnEdge on_edge(Crossing& root, int sign);
  /// Is the first crossing before the second? Refines both until that is certain.
  bool before(Crossing& a, Crossing& b);
  /// Encloses the crossing to within a few ulps.
  void tighten(Crossing& c);
  const StageCounts& stages() const { return memory_.stages; }

 private:
  void refine(Crossing& c, int sign, Stage stage);
  PreciseTriple triple(const CertificateFunction& function) { return {segment_, geometry_, function, &memory_}; }

  const PairGeometry& geometry_;
  const MotionSegment& segment_;
  CrossingDirections directions_;
  FrameMemory memory_;
};

// Crossings near a singular end of a segment, where windows of time are short.

/// Where a motion begins or ends with infinite speed, windows of time become shorter and shorter towards that instant,
/// several for each factor of two. If doubles do not decide in one window, they do not decide in the next one. A search
/// at high precision from the instant itself takes about as long for all of that time as for a single window. So each
/// pair is searched once over the whole remaining neighbourhood of the end, and the result is kept for the following
/// windows.
class CrossingsNearEnd {
 public:
  CrossingsNearEnd(const MotionSegment& segment, CrossingDirections directions, PreciseCrossings& precise)
      : segment_(segment), directions_(directions), precise_(precise) {}

  bool is_near(double t) const;
  /// Has the pair been searched from there, or from before?
  bool covers(const VertexEdge& pair, double t) const {
    const auto known = known_.find(pair.number());
    return known != known_.end() && !known->second.hopeless && known->second.covers(t);
  }
  /// The pair's first crossing in (from, to]. Throws Undecidable.
  std::optional<Crossing> first(const VertexEdge& pair, double from, double to);

 private:
  /// The result for a pair from an instant on, up to the end of the neighbourhood.
  struct Foreseen {
    double from = 0, to = 0;
    std::optional<Crossing> crossing;  ///< the first one
    bool hopeless = false;             ///< a later event, which may not matter, cannot be decided
    bool covers(double t) const { return from <= t && t < to && !(crossing && crossing->hi <= t); }
  };

  /// Null if the search is hopeless.
  const Foreseen* foreseen(const VertexEdge& pair, double from, double until);
  /// If all crossings are searched for, each belongs to one of the stretches that divide time. A first contact that may
  /// lie in this stretch or in the next one is reported in both.
  bool within(const Crossing& c, double to) const {
    return directions_ == CrossingDirections::both ? c.hi <= to : c.lo <= to;
  }

  const MotionSegment& segment_;
  CrossingDirections directions_;
  PreciseCrossings& precise_;
  std::unordered_map<std::uint64_t, Foreseen> known_;
};

}  // namespace taut::internal::spacetime
