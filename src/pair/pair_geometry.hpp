// The two displaced polygons, as one sequence of vertices.
#pragma once

#include <utility>

#include "geometry/displaced_orientation.hpp"
#include "geometry/displacement.hpp"
#include "geometry/ids.hpp"

namespace taut {

/// P's vertices (0 .. np-1), then Q's (np .. np+nq-1), each counterclockwise, the first on its convex hull.
/// Coordinates are scaled to at most 1 in magnitude. Copies share the polygons.
struct PairGeometry {
  PairGeometry() = default;
  PairGeometry(SharedPolygon first, SharedPolygon second)
      : np(static_cast<std::uint32_t>(first->points.size())),
        nq(static_cast<std::uint32_t>(second->points.size())),
        p_(std::move(first)),
        q_(std::move(second)),
        points_p_(p_->points.data()),
        points_q_(q_->points.data()) {}
  PairGeometry(std::vector<DisplacedPoint> first, std::vector<DisplacedPoint> second)
      : PairGeometry(std::make_shared<const DisplacedPolygon>(std::move(first)),
                     std::make_shared<const DisplacedPolygon>(std::move(second))) {}

  std::uint32_t np = 0, nq = 0;

  const SharedPolygon& p() const { return p_; }
  const SharedPolygon& q() const { return q_; }
  std::uint32_t size() const { return np + nq; }
  bool in_p(VertexId v) const { return v.value < np; }
  bool same_body(VertexId a, VertexId b) const { return in_p(a) == in_p(b); }
  const DisplacedPoint& point(VertexId v) const { return v.value < np ? points_p_[v.value] : points_q_[v.value - np]; }
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
  int rigid_orientation(VertexId a, VertexId b, VertexId c) const { return orientation(point(a), point(b), point(c)); }
  /// Bytes that the polygons take, shared or not.
  std::size_t bytes() const { return size() * sizeof(DisplacedPoint); }

 private:
  SharedPolygon p_, q_;
  const DisplacedPoint *points_p_ = nullptr, *points_q_ = nullptr;
};

}  // namespace taut
