// Small polygons that fit onto one another: lattice shapes, and the same squashed to blades and slivers.
#pragma once

#include "support/rng.hpp"
#include "taut/geometry.hpp"

namespace taut::testing {

/// A linear map with short numbers, so that no image of a lattice point is rounded.
struct ShortMap {
  double xx = 1, xy = 0, yx = 0, yy = 1;
  Point operator()(const Point& p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
};

/// `sharp`: angles of 1e-6 to 0.05; else of the lattice.
ShortMap random_map(Rng& rng, bool sharp);

/// One of some shapes of 3 to 8 vertices, convex and not, with vertices in the middle of faces; mapped, and moved so
/// that a vertex of its own is the origin.
Polygon random_shape(Rng& rng, const ShortMap& map);

/// A vertex or, now and then, the middle of an edge.
Point random_place(Rng& rng, const Polygon& polygon);
/// Along an edge of one of the polygons or between two of their vertices; now and then along the lattice.
Point random_way(Rng& rng, const Polygon& p, const Polygon& q);

}  // namespace taut::testing
