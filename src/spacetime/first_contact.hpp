// The second engine: bounding boxes over the edges, followed through time. It shares no idea with the tiling, and its
// purpose is to disagree with it if either is wrong.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "certificate/feature_map.hpp"
#include "certificate/precise_time.hpp"
#include "motion/motion_segments.hpp"
#include "numeric/errors.hpp"
#include "scene/body_pair.hpp"
#include "scene/pair_geometry.hpp"
#include "spacetime/hierarchy.hpp"
#include "spacetime/uniform_motion.hpp"

namespace taut::internal::spacetime {

struct SpacetimeResult {
  enum Outcome : unsigned char {
    free,       ///< proved: no vertex of one body meets an edge of the other on any segment
    contact,    ///< the first contact, certainly
    undecided,  ///< the precision of the last stage did not suffice, or the run was interrupted
  };
  Outcome outcome = undecided;
  FoundContact found;  ///< if the outcome is a contact
  /// No contact occurs before `lo` on segment `segment`, or on the segments before it.
  std::size_t segment = 0;
  double lo = 0;
  std::string reason;  ///< the reason, if undecided
  /// The numbers of pairs of boxes tested, and of roots isolated in doubles.
  std::uint64_t pairs = 0, roots = 0;
  StageCounts stages;  ///< counts of the stages that decided where doubles did not
};

/// A part of the world's time that excludes its beginning, so that consecutive windows contain each joint once.
struct TimeWindow {
  double from = 0, to = 0;
  bool first = true;  ///< it begins with the scene, and includes its beginning
};

/// The search for the first contact of the two displaced polygons along the segments (as made by make_segments), or
/// along their part in a window. It requires that the polygons are disjoint at the start of the first segment (see
/// overlapping(); otherwise the answer has no meaning). `free` and `contact` are proofs: every sign and every order of
/// two instants on which they depend is certified.
class ContactSearch {
 public:
  /// All arguments must outlive the search.
  ContactSearch(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                const std::optional<TimeWindow>& window = std::nullopt);
  ~ContactSearch();
  ContactSearch(ContactSearch&&) noexcept;
  /// Continues until the end, or until the slice is used up: then there is no result yet. The result is `undecided` if
  /// a checkpoint interrupts the search. Counts in it refer to the search from its beginning.
  std::optional<SpacetimeResult> advance(const Slice& slice);
  /// Runs to the end at once.
  SpacetimeResult run();

 private:
  struct State;
  std::unique_ptr<State> state_;
};
/// Runs the whole search without interruption.
SpacetimeResult first_contact(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments);

/// A crossing of an edge by a vertex, on a segment.
struct SegmentCrossing {
  VertexId vertex, edge;
  bool out = false;  ///< from inside to outside
  std::size_t segment = 0;
  double lo = 0, hi = 0;               ///< encloses the segment's parameter
  std::optional<PreciseTime> precise;  ///< within [lo, hi]; set once a stage has refined it
};
/// All crossings of edges of one body by vertices of the other within the windows, which must be ordered and disjoint.
/// The crossings of a segment are in no particular order. Between two crossings that follow each other in time, the
/// same edges cross, if the bodies are disjoint outside of the windows. The enclosures are as tight as was needed to
/// separate each crossing from others of the same two features. Throws Undecidable.
std::vector<SegmentCrossing> all_crossings(const PairGeometry& geometry, const TreePair& trees,
                                           const MotionSegments& segments, const std::vector<TimeWindow>& windows);

/// Encloses a crossing to within a few ulps. Its instant is computed to the relative accuracy `share`. If that is 0, it
/// is computed as accurately as the first precise stage allows, which takes several times as long.
void tighten(const PairGeometry& geometry, const MotionSegments& segments, SegmentCrossing& crossing, double share);

/// Do the displaced polygons overlap at t? The segment must not be a bridge. Throws Undecidable. Counts the stages that
/// decided where doubles did not.
std::optional<StartOverlap> overlapping(const PairGeometry& geometry, const TreePair& trees,
                                        const MotionSegment& segment, double t, StageCounts* stages = nullptr);
/// Like overlapping(), for callers that know the motion at that instant: `instant` is a stretch of zero length.
std::optional<StartOverlap> overlapping(const PairGeometry& geometry, const TreePair& trees,
                                        const MotionSegment& segment, double t, const Stretch& instant);
/// Like overlapping(), with trees of its own.
std::optional<StartOverlap> overlapping(const PairGeometry& geometry, const MotionSegment& segment, double t);

/// Boxes around moving bodies meet far more often than the bodies come near each other. Where both move uniformly, a
/// sine and a cosine make a stretch (UniformMotion), at a hundredth of the cost of a model over the window. A few
/// stretches show most of these pairs to be disjoint. True is a proof for all of [from, to] of the segment's parameter;
/// false has no meaning.
bool quickly_apart(const TreePair& trees, const MotionSegment& segment, double from, double to);

}  // namespace taut::internal::spacetime
