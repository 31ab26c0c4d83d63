// The pairs of a scene in the terms of a log of separations: their ranges of edges, and how they move.
#pragma once

#include <cstddef>
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

// Which pairs of bodies a window of a log of separations has to say something about.

using BodyPairs = std::vector<std::pair<int, int>>;

/// The pairs that are open in a window: all that are asked about but one, as long as windows are halved without a word,
/// and later those that a longer window has left.
struct OpenPairs {
  std::optional<BodyPairs> listed;

  bool all() const { return !listed; }
};

/// The boxes of all bodies in a window: those that windows around it have stated, and of bodies at rest those around
/// their outlines.
class WindowBoxes {
 public:
  /// `room` as stays_within() wants it.
  WindowBoxes(const VerifierScene& scene, double room);

  const AxisBox& of(int body) const { return boxes_[static_cast<std::size_t>(body)]; }
  void state(int body, const AxisBox& box) { boxes_[static_cast<std::size_t>(body)] = box; }
  /// Those of two bodies. Boxes that are stated have room around the body; those of two bodies at rest need it here.
  bool meet(int a, int b) const {
    const bool rest = rests_[static_cast<std::size_t>(a)] && rests_[static_cast<std::size_t>(b)];
    return rest ? within_room(of(a), of(b)) : of(a).meets(of(b));
  }
  /// All pairs that are asked about and whose boxes meet, in order; nothing if they are more than `most`. By sweeping
  /// along the axis along which fewer meet.
  std::optional<BodyPairs> meeting(const VerifierScene& scene, std::size_t most = SIZE_MAX) const;

 private:
  bool sweep_along_x() const;
  bool within_room(const AxisBox& a, const AxisBox& b) const {
    const auto near = [this](double lo, double hi) { return !(lo - hi > room_); };
    return near(a.lo_x, b.hi_x) && near(b.lo_x, a.hi_x) && near(a.lo_y, b.hi_y) && near(b.lo_y, a.hi_y);
  }

  double room_;  ///< with what rounds
  std::vector<AxisBox> boxes_;
  std::vector<bool> rests_;
};

inline AxisBox as_doubles(const StatedBox& b) { return {b.lo_x, b.lo_y, b.hi_x, b.hi_y}; }

/// The bodies that move and are in any of the pairs, in order; where all pairs are open, all that move.
std::vector<int> moving_bodies(const VerifierScene& scene, const OpenPairs& open);

}  // namespace taut::internal::proof
