// Points and arcs of curves, as the verifier of proofs about curves computes them.
#pragma once

#include <array>
#include <optional>

#include "numeric/ball.hpp"
#include "taut/geometry.hpp"
#include "taut/outline.hpp"

namespace taut::internal::proof {

using CurveReal = WideFloat<192>;
using CurveNumber = Ball<CurveReal>;

/// A sign, 0 included; nothing if it is not certain.
using CertainSign = std::optional<int>;

inline bool is_exact(const CurveNumber& x) { return x.rad == 0 && x.mid.is_defined(); }
inline bool is_zero(const CurveNumber& x) { return is_exact(x) && x.mid.is_zero(); }

/// The sum; exact if both are, and 192 bits hold it.
CurveNumber sum_of(const CurveNumber& a, const CurveNumber& b);
/// The sign of a - b.
CertainSign order_of(const CurveNumber& a, const CurveNumber& b);

struct CurvePoint {
  CurveNumber x, y;

  static CurvePoint of(const Point& p) { return {CurveNumber::exact(p.x), CurveNumber::exact(p.y)}; }
  Point rounded() const { return {x.mid.to_double(), y.mid.to_double()}; }
};

CurvePoint middle_of(const CurvePoint& a, const CurvePoint& b);

/// The sign of (b - a) x (c - a): is c to the left (1) or to the right (-1) of the line from a to b, or on it (0)?
CertainSign side_of(const CurvePoint& a, const CurvePoint& b, const CurvePoint& c);

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
