// The pairs of a scene in the terms of a log of separations: their ranges of edges, and how they move.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "proof/apart_checker.hpp"
#include "proof/stated_box.hpp"
#include "proof/verifier_scene.hpp"
#include "scene/placement.hpp"

namespace taut::internal::proof {

/// One pair that is asked about.
struct VerifierPair {
  BodyPair bodies;
  PairGeometry geometry;
  MotionSegments segments;
  RangedPair ranges;

  VerifierPair(BodyPair pair, PairGeometry displaced, MotionSegments all_segments, const EdgeRanges& p,
               const EdgeRanges& q)
      : bodies(std::move(pair)),
        geometry(std::move(displaced)),
        segments(std::move(all_segments)),
        ranges{geometry, p, q} {}
  VerifierPair(const VerifierPair&) = delete;
  VerifierPair& operator=(const VerifierPair&) = delete;
};

/// A stretch of a segment's parameter.
struct SegmentStretch {
  std::size_t segment = 0;
  double from = 0, to = 0;
};

/// Bodies displaced one way, prepared when first asked for.
class VerifierWorld {
 public:
  /// The scene must outlive it. The margin is in internal units.
  VerifierWorld(const VerifierScene& scene, Offset offset, double margin = 0)
      : scene_(scene), offset_(offset), margin_(margin) {}

  const VerifierScene& scene() const { return scene_; }
  Offset offset() const { return offset_; }
  double margin() const { return margin_; }
  /// Valid until another pair is asked for: of many pairs, only some are kept.
  VerifierPair& pair(int a, int b);
  /// Around a box around a body has to be so much room.
  double room() const { return margin_ + box_room; }

 private:
  const EdgeRanges& ranges(const RingSet& body);

  const VerifierScene& scene_;
  Offset offset_;
  double margin_;
  std::unordered_map<const RingSet*, std::unique_ptr<EdgeRanges>> ranges_;
  std::map<std::pair<int, int>, std::unique_ptr<VerifierPair>> pairs_;
};

/// What of a pair's segments lies in that time, in order.
std::vector<SegmentStretch> stretches(const MotionSegments& segments, const WorldTime& time);

/// All of the segments before one.
void add_stretches_before(const MotionSegments& segments, std::size_t segment, std::vector<SegmentStretch>& all);

/// Do the two bodies overlap at an instant: do their boundaries cross, or does one lie in the other's material?
/// Separations show that no vertex is on an edge; where two edges cross in the shape of a plus none is.
bool overlap_at(const VerifierPair& pair, const MotionSegment& segment, double t);
/// Throws ProofError unless the two edges, by their first vertices, cross.
void require_crossing(const Placement& place, VertexId e, VertexId f);
/// Does the other body's material contain that vertex?
bool inside_the_other(const Placement& place, VertexId vertex);

}  // namespace taut::internal::proof
