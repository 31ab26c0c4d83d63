// Points of the plane with rational coordinates, and exact signs of what they are to each other.
#pragma once

#include <optional>
#include <vector>

#include "geometry/axis_box.hpp"
#include "numeric/dyadic.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::path {

/// The point (x / w, y / w), exactly; w > 0.
struct ExactPoint {
  Dyadic x, y, w;
  Point near;  ///< rounded: each coordinate is off by less than 2^-51 of its size

  static ExactPoint of(Dyadic x, Dyadic y);
  /// With w of either sign, but not 0.
  static ExactPoint of(Dyadic x, Dyadic y, Dyadic w);
};

/// a / b, rounded; b is not 0.
double nearest_quotient(const Dyadic& a, const Dyadic& b);

/// The sign of (b - a) x (c - a). Exact.
int turn_sign(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);
bool same(const ExactPoint& a, const ExactPoint& b);

/// Where the line through `a` and `b` meets the one through `c` and `d`, if they are not parallel.
std::optional<ExactPoint> line_meeting(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                       const ExactPoint& d);
/// The only point that two segments have in common, if they are not parallel.
std::optional<ExactPoint> meeting_point(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                        const ExactPoint& d);
/// The point of the segment from `a` to `b` that is straight across from `p`, if there is one.
std::optional<ExactPoint> foot_point(const ExactPoint& p, const ExactPoint& a, const ExactPoint& b);

/// A convex polygon, counterclockwise; corners may be flat.
using ConvexRing = std::vector<ExactPoint>;

/// A ring without corners that come twice in a row: of one point, of the two ends of a segment, or of an area.
ConvexRing without_repeated(const ConvexRing& ring);
/// Is the point in the closed set? The ring has no corners that come twice in a row.
bool contains(const ConvexRing& ring, const ExactPoint& p);
/// Is the point in the open one, which has an area?
bool is_inside(const ConvexRing& ring, const ExactPoint& p);

/// The middle of its corners, rounded.
ExactPoint rounded_middle(const ConvexRing& ring);

/// More than points are rounded by.
AxisBox bounds_of(const ConvexRing& ring);
AxisBox bounds_of(const ExactPoint& a, const ExactPoint& b);

}  // namespace taut::internal::path
