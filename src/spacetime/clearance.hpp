// The minimum distance of two bodies, by branch and bound over time and pairs of boxes.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/vector.hpp"
#include "spacetime/first_contact.hpp"
#include "taut/check.hpp"

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

/// Lowers `best` to the least distance of the two bodies along the segments, up to `until`, where that is less.
/// Afterwards, no distance is less than the smaller one of tolerance.least(best.distance) and best.unresolved. The
/// bodies must not touch at any time.
void find_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments, double until,
                  const ClearanceTolerance& tolerance, Nearest& best);
/// Like find_nearest() for from <= t <= to, an instant if they are equal. Jumps at joints are omitted; they are
/// rounding.
void find_nearest_within(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                         double from, double to, const ClearanceTolerance& tolerance, Nearest& best);
/// Like find_nearest() in the middle of a stretch of a segment, with the errors of that stretch. The nearest edges
/// there are nearly always determined correctly, without an evaluation of the motion.
void find_nearest_in_middle(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment,
                            const Stretch& stretch, const ClearanceTolerance& tolerance, Nearest& best);

/// Closes the gap that find_nearest() may have left. Whether the bodies keep a margin is decided at any precision, so
/// queries with margins between the certain lower bound and the least distance found bring the two together. The search
/// is within a window, at whose start the bodies must not overlap. Afterwards best.unresolved is infinite, or the
/// search for a margin was not decided, and the reason is returned.
std::string resolve_nearest(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                            const TimeInterval& window, const ClearanceTolerance& tolerance, Nearest& best);

/// An upper bound of the bodies' distance at all times from `from` to `to` (from < to), in internal units. Any two
/// points of the bodies bound the distance. Here they belong to a vertex and an edge that are nearest in the middle, so
/// the bound becomes tight as the stretch becomes short.
double distance_bound(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments, double from,
                      double to, const ClearanceTolerance& tolerance);

// The nearest points of two segments.

/// The nearest points of two segments that do not cross, rounded.
struct Closest {
  Vector on_p, on_q;
  double distance = INFINITY;

  static Closest of(Vector a, Vector b, Vector c, Vector d) {
    Closest best;
    best.attempt(a, c, d, true);
    best.attempt(b, c, d, true);
    best.attempt(c, a, b, false);
    best.attempt(d, a, b, false);
    return best;
  }

 private:
  void attempt(Vector v, Vector from, Vector to, bool v_of_p) {
    const Vector e = to - from, w = v - from;
    const double share = std::clamp(dot(w, e) / dot(e, e), 0.0, 1.0);
    const Vector foot{from.x + share * e.x, from.y + share * e.y}, relative = v - foot;
    const double d = std::sqrt(dot(relative, relative));
    if (!(d < distance)) return;
    on_p = v_of_p ? v : foot;
    on_q = v_of_p ? foot : v;
    distance = d;
  }
};

}  // namespace taut::internal::spacetime
