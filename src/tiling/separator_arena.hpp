// Two polygons at rest, triangulated: where separators are searched.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scene/body_pair.hpp"
#include "tiling/free_triangulation.hpp"

namespace taut::internal {

/// Two disjoint polygons at rest. Coordinates are scaled as in BodyPair; the free space is triangulated inside a box,
/// whose corners are vertices size() .. size()+3.
struct Arena {
  BodyPair bodies;
  PairGeometry geometry;
  std::vector<Point> points;  ///< of P, of Q, and of the box
  FreeTriangulation triangulation;
  /// RCH(P) and RCH(Q): the vertices in order, the polygon on the left; each first vertex once.
  std::array<std::vector<VertexId>, 2> hulls;

  std::uint32_t size() const { return geometry.size(); }
  bool in_box(VertexId v) const { return v.value >= size(); }
  /// 0: P, 1: Q, 2: the box.
  int owner(VertexId v) const { return in_box(v) ? 2 : (geometry.in_p(v) ? 0 : 1); }
  const Point& at(VertexId v) const { return points[v.value]; }

  VertexId origin(std::uint32_t h) const { return triangulation.origin[h]; }
  VertexId target(std::uint32_t h) const { return triangulation.target(h); }
  std::uint32_t twin(std::uint32_t h) const { return triangulation.twin[h]; }
  /// The third vertex of the triangle of h.
  VertexId apex(std::uint32_t h) const { return origin(FreeTriangulation::previous(h)); }
};

/// Empty if the polygons overlap, or one of them crosses itself.
std::optional<Arena> make_arena(const Polygon& a, const Polygon& b);

}  // namespace taut::internal
