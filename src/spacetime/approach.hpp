// Two features that come as close as a margin: the roots that may be the first such instants, at any precision.
#pragma once

#include <optional>

#include "sign/precise_time.hpp"
#include "sign/taylor_frames.hpp"
#include "spacetime/crossing.hpp"

namespace taut::internal::spacetime {

/// A vertex of one body, and what it may come close to: an edge of the other one, by its first vertex, or a vertex.
struct VertexPeer {
  VertexId vertex, peer;
  bool is_edge = false;
};

/// The instant at which they come as close as the margin, the vertex from in front of the edge: the only one in [lo,
/// hi]. If the search began so close already, that instant.
struct Approach {
  VertexPeer pair;
  double lo = 0, hi = 0;
  PreciseTime precise;  ///< within [lo, hi]; with doubles that of the search's beginning
};

/// For one segment that is no bridge. All members throw Undecidable where the last stage does not suffice.
///
/// Two bodies that are apart, and come closer to each other than the margin, do so between a vertex and an edge beside
/// which it is, or between two vertices. So these are all that has to be looked at.
class PreciseApproaches {
 public:
  /// The margin is in internal units, and positive.
  PreciseApproaches(const PairGeometry& geometry, const MotionSegment& segment, double margin)
      : geometry_(geometry), segment_(segment), margin_(margin) {}

  /// The first one in (from, to].
  std::optional<Approach> first(const VertexPeer& pair, double from, double to) const;
  /// Are they closer than the margin at t?
  bool close_at(const VertexPeer& pair, double t) const;
  /// Is the first one before the second? Refines both until that is certain.
  bool before(Approach& a, Approach& b) const;
  /// The sign of the function whose root an approach is, positive where they are closer; 0 if that is not decided.
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
  double margin_;
  mutable TaylorFrames models_;  ///< of the segment, which many pairs are asked about
};

}  // namespace taut::internal::spacetime
