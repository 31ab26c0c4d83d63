// The two displaced polygons, in one array of vertices.
#pragma once

#include <span>
#include <vector>

#include "geometry/displaced_orientation.hpp"
#include "geometry/ids.hpp"

namespace taut {

/// P's vertices (0 .. np-1), then Q's (np .. np+nq-1), each counterclockwise, the first on its convex hull.
/// Coordinates are scaled to at most 1 in magnitude.
struct PairGeometry {
  std::vector<DisplacedPoint> points;
  std::uint32_t np = 0, nq = 0;
  /// Some feature may be smaller than the displacement: then the displaced polygons must be checked to be simple.
  bool fine_features = false;

  std::uint32_t size() const { return np + nq; }
  bool in_p(VertexId v) const { return v.value < np; }
  bool same_body(VertexId a, VertexId b) const { return in_p(a) == in_p(b); }
  const DisplacedPoint& point(VertexId v) const { return points[v.value]; }
  VertexId next(VertexId v) const {
    if (v.value + 1 == np) return VertexId(0u);
    if (v.value + 1 == np + nq) return VertexId(np);
    return VertexId(v.value + 1);
  }
  VertexId previous(VertexId v) const {
    if (v.value == 0) return VertexId(np - 1);
    if (v.value == np) return VertexId(np + nq - 1);
    return VertexId(v.value - 1);
  }
  /// Orientation of three vertices of one body.
  int rigid_orientation(VertexId a, VertexId b, VertexId c) const {
    return orientation(points[a.value], points[b.value], points[c.value]);
  }
};

}  // namespace taut
