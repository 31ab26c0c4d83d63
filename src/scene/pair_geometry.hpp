// The two displaced bodies, as one sequence of vertices.
#pragma once

#include <utility>

#include "geometry/displacement.hpp"
#include "geometry/ids.hpp"

namespace taut::internal {

/// P's vertices (0 .. np-1), then Q's (np .. np+nq-1), each counterclockwise, the first on its convex hull. A body of
/// several rings has them one after the other, holes clockwise: the material is to the left of every edge. Coordinates
/// are scaled to at most 1 in magnitude. Copies share the polygons.
struct PairGeometry {
  PairGeometry() = default;
  PairGeometry(SharedPolygon first, SharedPolygon second)
      : np(static_cast<std::uint32_t>(first->points.size())),
        nq(static_cast<std::uint32_t>(second->points.size())),
        p_(std::move(first)),
        q_(std::move(second)),
        points_p_(p_->points.data()),
        points_q_(q_->points.data()),
        ringed_(!p_->rings.empty() || !q_->rings.empty()) {}
  PairGeometry(std::vector<DisplacedPoint> first, std::vector<DisplacedPoint> second)
      : PairGeometry(std::make_shared<const DisplacedPolygon>(std::move(first)),
                     std::make_shared<const DisplacedPolygon>(std::move(second))) {}

  std::uint32_t np = 0, nq = 0;

  const SharedPolygon& p() const { return p_; }
  const SharedPolygon& q() const { return q_; }
  std::uint32_t size() const { return np + nq; }
  bool in_p(VertexId v) const { return v.value < np; }
  Role role_of(VertexId v) const { return in_p(v) ? Role::p : Role::q; }
  /// Of that body: the number of its first vertex, and how many it has.
  std::uint32_t first(Role role) const { return role == Role::p ? 0 : np; }
  std::uint32_t count(Role role) const { return role == Role::p ? np : nq; }
  bool same_body(VertexId a, VertexId b) const { return in_p(a) == in_p(b); }
  const DisplacedPoint& point(VertexId v) const { return v.value < np ? points_p_[v.value] : points_q_[v.value - np]; }
  VertexId next(VertexId v) const {
    if (ringed_) return along_ring(v, &DisplacedPolygon::next, true);
    if (v.value + 1 == np) return VertexId(0u);
    if (v.value + 1 == np + nq) return VertexId(np);
    return VertexId(v.value + 1);
  }
  VertexId previous(VertexId v) const {
    if (ringed_) return along_ring(v, &DisplacedPolygon::previous, false);
    if (v.value == 0) return VertexId(np - 1);
    if (v.value == np) return VertexId(np + nq - 1);
    return VertexId(v.value - 1);
  }
  /// Orientation of three vertices of one body.
  int rigid_orientation(VertexId a, VertexId b, VertexId c) const { return orientation(point(a), point(b), point(c)); }
  /// Bytes that the polygons take, shared or not.
  std::size_t bytes() const { return size() * sizeof(DisplacedPoint); }

 private:
  /// The neighbour of v in its ring by a body's own table; a body of one ring has none.
  VertexId along_ring(VertexId v, std::vector<std::uint32_t> DisplacedPolygon::*table, bool forwards) const {
    const DisplacedPolygon& body = in_p(v) ? *p_ : *q_;
    const std::uint32_t start = in_p(v) ? 0 : np, n = in_p(v) ? np : nq, k = v.value - start;
    if (!body.rings.empty()) return VertexId(start + (body.*table)[k]);
    return VertexId(start + (forwards ? (k + 1) % n : (k + n - 1) % n));
  }

  SharedPolygon p_, q_;
  const DisplacedPoint *points_p_ = nullptr, *points_q_ = nullptr;
  bool ringed_ = false;
};

}  // namespace taut::internal
