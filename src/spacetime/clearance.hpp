// How close do two bodies come? Branch and bound over time and pairs of boxes.
#pragma once

#include <cmath>
#include <vector>

#include "spacetime/first_contact.hpp"

namespace taut::internal::spacetime {

/// The least distance found so far, in internal units, and where.
struct Nearest {
  double distance = 0;  ///< certainly not less than the bodies' distance at that instant
  std::size_t segment = 0;
  double parameter = 0;
  VertexId edge_p, edge_q;  ///< the edges that come so close, by their first vertices
  /// No distance is less than this where doubles did not tell as well as was asked for, or not soon; infinite if they
  /// always did.
  double unresolved = INFINITY;
};

/// What a distance may be wrong by: `relative` of it, and `absolute`.
struct ClearanceTolerance {
  double relative = 0, absolute = 0;
  double least(double distance) const { return distance * (1 - relative) - absolute; }
};

/// Lowers `best` to the least distance of the two bodies along the segments, where that is less: afterwards, no
/// distance is less than the smaller one of tolerance.least(best.distance) and best.unresolved. The bodies must not
/// touch at any time.
void find_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                  const ClearanceTolerance& tolerance, Nearest& best);
/// The same for from <= t <= to, an instant if they are equal; jumps at joints are left out, which are rounding.
void find_nearest_within(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                         double from, double to, const ClearanceTolerance& tolerance, Nearest& best);
/// The same in the middle of a stretch of a segment, with that stretch's errors: which edges are nearest there is
/// nearly always told right, and costs no look at the motion.
void find_nearest_in_middle(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment,
                            const Stretch& stretch, const ClearanceTolerance& tolerance, Nearest& best);

}  // namespace taut::internal::spacetime
