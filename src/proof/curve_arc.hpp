// Arcs of SVG, derived for the verifier alone: by the symmetry of an arc about its middle.
#pragma once

#include "proof/curve_point.hpp"
#include "taut/outline.hpp"

namespace taut::internal::proof {

/// The image of the unit circle under u -> centre + u.x a + u.y b.
struct Ellipse {
  CurvePoint centre, a, b;
  /// Its axes are along x and y, and centre and half-axes known to the last bit.
  bool exact = false;

  CurvePoint at(const CurvePoint& u) const;
};

/// Where on the unit circle an arc begins and ends.
struct EllipseArc {
  Ellipse ellipse;
  CurvePoint first, last;
};

/// Radii are not zero, the ends differ.
///
/// Half-axes are taken as units. Let e be the direction of the chord, n that across it to which the arc bulges, and
/// 2 s its length. The arc is symmetric about n, so that it begins at -sin e + cos n and ends at sin e + cos n, where
/// sin = s, and cos = sqrt(1 - s^2), or minus that if the arc is more than a half. Where s is more than 1, radii do not
/// reach: in units that are s times as large, sin is 1 and cos is 0. The centre is the middle of the chord less cos n.
EllipseArc ellipse_arc(const Point& from, const ArcTo& arc);

/// Across the chord, to the side to which the arc bulges: the middle of the arc from u to v, of unit length.
CurvePoint middle_of_arc(const CurvePoint& u, const CurvePoint& v, bool counterclockwise);

}  // namespace taut::internal::proof
