// The second engine: bounding boxes over the edges, followed through time. It shares no idea with the tiling, and its
// purpose is to disagree with it if either is wrong.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "pair/pair_geometry.hpp"
#include "relative/motion_segments.hpp"
#include "sign/feature_map.hpp"
#include "sign/precise_time.hpp"
#include "spacetime/hierarchy.hpp"

namespace taut::internal::spacetime {

struct SpacetimeResult {
  enum Outcome : unsigned char {
    free,       ///< proved: no vertex of one body meets an edge of the other on any segment
    contact,    ///< the first contact, certainly
    undecided,  ///< the precision of the last stage did not suffice, or the run was interrupted
  };
  Outcome outcome = undecided;
  FoundContact found;  ///< if it is one
  /// No contact happens before `lo` on segment `segment`, or on the segments before it.
  std::size_t segment = 0;
  double lo = 0;
  std::string reason;  ///< if undecided: why
  /// Pairs of boxes looked at, and roots isolated in doubles.
  std::uint64_t pairs = 0, roots = 0;
  StageCounts stages;  ///< which told where doubles did not
};

/// A stretch of the world's time, without its beginning: windows that follow each other have each joint once.
struct TimeWindow {
  double from = 0, to = 0;
  bool first = true;  ///< it begins with the scene, and has its beginning
};

/// The search for the first contact of the two displaced polygons along the segments (as made by make_segments), or on
/// what of them lies in a window, given that they are disjoint at the start of the first (see overlapping(); if they
/// are not, the answer means nothing). `free` and `contact` are proofs: every sign and every order of two instants
/// behind them is certified.
class ContactSearch {
 public:
  /// All of it must outlive the search.
  ContactSearch(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                const std::optional<TimeWindow>& window = std::nullopt);
  ~ContactSearch();
  ContactSearch(ContactSearch&&) noexcept;
  /// What an interruption point ends in the middle is `undecided`; the next call goes on there. What came of the search
  /// is counted from its beginning.
  SpacetimeResult go_on();

 private:
  struct State;
  std::unique_ptr<State> state_;
};
/// The same in one go.
SpacetimeResult first_contact(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments);

/// A crossing of an edge by a vertex, on a segment.
struct SegmentCrossing {
  VertexId vertex, edge;
  bool out = false;  ///< from inside to outside
  std::size_t segment = 0;
  double lo = 0, hi = 0;               ///< encloses the segment's parameter
  std::optional<PreciseTime> precise;  ///< within [lo, hi]; once a stage has looked at it
};
/// All crossings of edges of one body by vertices of the other within the windows, which are in order and apart, each
/// segment's in no particular order: between two of them that follow each other in time, the same edges cross, if the
/// bodies are apart outside of the windows. They are enclosed as far as telling them apart from others of the same two
/// features took. Throws Undecidable.
std::vector<SegmentCrossing> all_crossings(const PairGeometry& geometry, const TreePair& trees,
                                           const MotionSegments& segments, const std::vector<TimeWindow>& windows);

/// Encloses a crossing within a few ulps. Its instant is computed to such a share of itself, 0 being as well as numbers
/// of the first precise stage tell, which takes several times as long.
void tighten(const PairGeometry& geometry, const MotionSegments& segments, SegmentCrossing& crossing, double share);

/// Do the displaced polygons overlap at t? The segment is not a bridge. Throws Undecidable.
/// Counts which stages told where doubles did not.
std::optional<StartOverlap> overlapping(const PairGeometry& geometry, const TreePair& trees,
                                        const MotionSegment& segment, double t, StageCounts* stages = nullptr);
/// The same for those who know the motion at that instant: `instant` is a stretch of no length.
std::optional<StartOverlap> overlapping(const PairGeometry& geometry, const TreePair& trees,
                                        const MotionSegment& segment, double t, const Stretch& instant);
/// The same with trees of its own.
std::optional<StartOverlap> overlapping(const PairGeometry& geometry, const MotionSegment& segment, double t);

}  // namespace taut::internal::spacetime
