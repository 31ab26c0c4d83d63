// The first time at which two bodies come closer than a margin.
#pragma once

#include <string>

#include "spacetime/approach.hpp"
#include "spacetime/first_contact.hpp"
#include "taut/check.hpp"

namespace taut::internal::spacetime {

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
