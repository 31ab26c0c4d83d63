// The minimum distance of two bodies, by branch and bound over time and pairs of boxes.
#pragma once

#include <cmath>
#include <vector>

#include "spacetime/first_contact.hpp"

namespace taut::internal::spacetime {

/// The least distance found so far, in internal units, and its place.
struct Nearest {
  double distance = 0;  ///< certainly not less than the bodies' distance at that instant
  std::size_t segment = 0;
  double parameter = 0;
  VertexId edge_p, edge_q;  ///< the edges at this distance, given by their first vertices
  /// A lower bound of all distances where doubles did not reach the requested accuracy, or not soon; infinite if they
  /// always did.
  double unresolved = INFINITY;
};

/// The admissible error of a distance d: `relative` * d plus `absolute`.
struct ClearanceTolerance {
  double relative = 0, absolute = 0;
  double least(double distance) const { return distance * (1 - relative) - absolute; }
};

/// Lowers `best` to the least distance of the two bodies along the segments, where that is less. Afterwards, no
/// distance is less than the smaller one of tolerance.least(best.distance) and best.unresolved. The bodies must not
/// touch at any time.
void find_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                  const ClearanceTolerance& tolerance, Nearest& best);
/// Like find_nearest() for from <= t <= to, an instant if they are equal. Jumps at joints are omitted; they are
/// rounding.
void find_nearest_within(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                         double from, double to, const ClearanceTolerance& tolerance, Nearest& best);
/// Like find_nearest() in the middle of a stretch of a segment, with the errors of that stretch. The nearest edges
/// there are nearly always determined correctly, without an evaluation of the motion.
void find_nearest_in_middle(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment,
                            const Stretch& stretch, const ClearanceTolerance& tolerance, Nearest& best);

}  // namespace taut::internal::spacetime
