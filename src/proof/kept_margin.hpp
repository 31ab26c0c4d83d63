// Features of two bodies that stay farther apart than a margin over a stretch of a segment.
#pragma once

#include "certificate/taylor_frames.hpp"
#include "proof/fine_instant.hpp"
#include "proof/separation.hpp"

namespace taut::internal::proof {

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
