// Points and arcs of curves, as the verifier of proofs about curves computes them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

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

// The verifier's own pieces of curves, each with points in whose hull it lies.
//
//   Lines: their ends.
//   Bezier curves: their control points, as Bernstein's polynomials are nonnegative and sum up to 1. De Casteljau's
//     halves are Bezier curves again.
//   Arcs of less than half an ellipse: the ends and the point at which the tangents there meet. On the unit circle,
//     between directions u and v, that is (u + v) / (1 + u v): an arc lies on its side of both tangents, and on that
//     of its chord. Affine maps keep that. Halves end in the middle of the arc.

struct CurvePiece {
  int segment = 0;
  double from = 0, to = 1;  ///< of the segment's parameter, to call it by; nothing is proved by it
  std::array<CurvePoint, 4> control;
  int size = 2;                            ///< of `control`; 2 is a straight line
  std::shared_ptr<const Ellipse> ellipse;  ///< of an arc
  CurvePoint first, last;                  ///< of an arc: on the unit circle

  bool is_line() const { return size == 2; }
  const CurvePoint& point(int i) const { return control[static_cast<std::size_t>(i)]; }
  const CurvePoint& begin() const { return point(0); }
  const CurvePoint& end() const { return point(size - 1); }
};

/// The ring, closed, as SVG reads it; segments of no length give nothing. Arcs are cut into
/// about quarters, where that is exact at the ends of the axes. Throws InputError where a number cannot be computed
/// with, `name` as its place.
std::vector<CurvePiece> pieces_of(const Outline& outline, const std::string& name);

/// Not of a line.
std::array<CurvePiece, 2> halves_of(const CurvePiece& piece);

}  // namespace taut::internal::proof
