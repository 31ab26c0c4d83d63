// The verifier's own pieces of curves, each with points in whose hull it lies.
//
//   Lines: their ends.
//   Bezier curves: their control points, as Bernstein's polynomials are nonnegative and sum up to 1. De Casteljau's
//     halves are Bezier curves again.
//   Arcs of less than half an ellipse: the ends and the point at which the tangents there meet. On the unit circle,
//     between directions u and v, that is (u + v) / (1 + u v): an arc lies on its side of both tangents, and on that
//     of its chord. Affine maps keep that. Halves end in the middle of the arc.
#pragma once

#include <memory>
#include <vector>

#include "proof/curve_arc.hpp"

namespace taut::internal::proof {

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
