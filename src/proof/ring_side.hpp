// Does a curve lie within a polygon, or around it? By an argument that knows nothing of how the polygon was found.
//
// Let P be a simple polygon, and C a closed curve in pieces, each in the hull H of a few points. Every piece is shown
// to be one of two kinds:
//
// S1: it is a straight segment, and an edge of P.
//
// S2: H has an inside; for every edge e of P there is a line along e, or through two of the points, which has H on one
// side and e on the other, H not all of it on the line; and a point z inside of H is inside of P (C within P), or
// outside (C around P).
//
// The inside of H is an open set on one side of each of these lines, so it meets no edge of P. It is connected, so all
// of it is where z is. H is the closure of its inside, so it lies in P with its boundary, or in the outside of P with
// its boundary. Hence:
//
// Within: C lies in P with its boundary, a disc. Around no point outside does C wind, so what C encloses lies in P.
//
// Around: C does not meet the inside of P, which is connected, so C winds around all of its points equally often. That
// it winds around one of them at all is computed: a piece and its chord are both in H, which does not contain that
// point, so it is the number of times that the polygon of the chords does. So what is inside of P is enclosed by C.
//
// Nothing more is needed of C: not that it does not meet itself, nor that its pieces are those of P's maker.
#pragma once

#include <string>

#include "proof/curve_arc.hpp"

namespace taut::internal::proof {

enum class RingSide {
  within,  ///< the curve in the polygon
  around,  ///< the polygon in the curve
};

/// Which segment of a curve is near, to call it by; nothing is proved by it.
struct NamedChord {
  int segment = 0;
  double from = 0, to = 1;
  Point begin, end;
};

/// Throws ProofError unless it is certain that the curve lies so. The polygon must be simple, which is not checked.
/// The pieces into which the curve was cut for that are returned.
std::vector<NamedChord> require_side(const std::vector<CurvePiece>& curve, const Polygon& polygon, RingSide side,
                                     const std::string& name);

}  // namespace taut::internal::proof
