// Three vertices of both bodies, and what is measured of them.
#pragma once

#include "pair/pair_geometry.hpp"

namespace taut {

/// Two vertices a, b of one body and a vertex c of the other.
struct MixedTriple {
  VertexId a, b, c;
  bool pp = false;  ///< a and b belong to P

  /// (u, v, w) turned cyclically so that the two of one body come first: the orientation is the same.
  static MixedTriple of(const PairGeometry& g, VertexId u, VertexId v, VertexId w) {
    if (g.same_body(u, v)) return {u, v, w, g.in_p(u)};
    if (g.same_body(v, w)) return {v, w, u, g.in_p(v)};
    return {w, u, v, g.in_p(w)};
  }
};

/// What is measured: the cross product (b - a) x (c - a), or the dot product (b - a) . (c - a).
enum class Measure : unsigned char { orientation, projection };

}  // namespace taut
