// The first time at which two bodies come closer than a margin.
#pragma once

#include <optional>
#include <string>

#include "certificate/margin_function.hpp"
#include "certificate/precise_time.hpp"
#include "certificate/taylor_frames.hpp"
#include "spacetime/crossing.hpp"
#include "spacetime/first_contact.hpp"
#include "taut/check.hpp"

namespace taut::internal::spacetime {

// Two features that come as close as a margin: the roots that may be the first such instants, at any precision.

/// A vertex of one body, and the feature that it may come close to: an edge of the other one, given by its first
/// vertex, or a vertex.
struct VertexPeer {
  VertexId vertex, peer;
  bool is_edge = false;
};

/// The instant at which the two features come as close as the margin; for an edge, the vertex comes from in front of
/// it. It is the only one in [lo, hi]. If they were already that close when the search began, it is that instant.
struct Approach {
  VertexPeer pair;
  double lo = 0, hi = 0;
  PreciseTime precise;  ///< within [lo, hi]; if found in doubles, the beginning of the search
};

/// Approaches on one segment, which must not be a bridge. All members throw Undecidable where the last stage does not
/// suffice.
///
/// Two disjoint bodies that come closer to each other than the margin do so between a vertex and an edge onto which it
/// projects, or between two vertices. So only these pairs have to be tested.
class PreciseApproaches {
 public:
  /// The margin is in internal units.
  PreciseApproaches(const PairGeometry& geometry, const MotionSegment& segment, const Margin& margin)
      : geometry_(geometry), segment_(segment), margin_(margin, segment) {}

  const SegmentMargin& margin() const { return margin_; }

  /// The first approach in (from, to].
  std::optional<Approach> first(const VertexPeer& pair, double from, double to) const;
  /// Are the features closer than the margin at t?
  bool close_at(const VertexPeer& pair, double t) const;
  /// Is the first approach before the second? Refines both until that is certain.
  bool before(Approach& a, Approach& b) const;
  /// The sign of the function whose root is an approach, positive where the features are closer; 0 if it is not
  /// decided.
  int side(const VertexPeer& pair, double t) const;

 private:
  template <class Real, class Use>
  auto with_functions(const VertexPeer& pair, const Use& use) const;
  template <class Real>
  std::optional<PreciseTime> first_root(const VertexPeer& pair, double from, double to, Stage stage) const;
  bool none_in_doubles(const VertexPeer& pair, double from, double to) const;
  void refine(Approach& a, Stage stage) const;

  const PairGeometry& geometry_;
  const MotionSegment& segment_;
  SegmentMargin margin_;
  mutable TaylorFrames models_;  ///< of the segment, shared by many pairs
};

/// The known relation of two bodies' distance to a margin, along the segments.
struct MarginResult {
  enum Outcome : unsigned char {
    free,       ///< proved: never closer than the margin
    close,      ///< as close as the margin within [lo, hi], and closer just after; not before
    undecided,  ///< the precision of the last stage did not suffice, or the run was interrupted; not closer before `lo`
  };
  Outcome outcome = free;
  std::size_t segment = 0;
  double lo = 0, hi = 0;  ///< of that segment's parameter
  VertexPeer pair;        ///< if `close`: the features that are as close as the margin
  bool at_once = false;   ///< if `close`: closer from the beginning of the segment on
  std::string reason;     ///< the reason, if undecided
};

/// Searches within a window, for the displaced bodies, at the times of segments. Jumps at joints are omitted; they are
/// rounding. The bodies must not overlap at the start of the window: bodies that come to overlap come closer than any
/// margin before. The margin is in internal units, and never negative. Bodies displaced inwards come to the margin
/// where the given ones are strictly closer than it, bodies displaced outwards where they are as close as it.
MarginResult first_closer(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                          const Margin& margin, const TimeInterval& window);

}  // namespace taut::internal::spacetime
