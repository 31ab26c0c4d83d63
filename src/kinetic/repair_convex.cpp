// Repairs at a convex corner that has closed.
#include "kinetic/repair.hpp"

namespace taut::internal {
namespace {

/// Called after a corner at the root closed: RCH(P) now traverses an edge with faces of P on both sides in both
/// directions.
void mark_pinch(PlanarMap& map, ChainNode face, HalfedgeId uv) {
  if (face != node::root && face != node::infinite_face) return;
  if (node::in_p(map.node(uv)) && node::in_p(map.node(PlanarMap::twin(uv)))) map.set_pinch(uv, true);
}

/// A triangle vanishes. The face across the removed edge gets the two other edges.
RepairReport without_triangle(PlanarMap& map, HalfedgeId gone, RepairReport report) {
  const HalfedgeId a = map.next(gone), b = map.next(a), across = PlanarMap::twin(gone);
  const HalfedgeId p = map.previous(across), n = map.next(across);
  map.link(p, a);
  map.link(b, n);
  map.set_node(a, map.node(across));
  map.set_node(b, map.node(across));
  map.remove_edge(gone);
  report.repair = Repair::convex_triangle;
  report.removed = gone;
  for (const HalfedgeId c : {p, a, b}) report.touch(c);
  return report;
}

/// The far end comes first: h = w -> u, next = u -> v. The edge u -> w is removed, and w -> v is added.
RepairReport far_end_first(PlanarMap& map, HalfedgeId wu, HalfedgeId uv) {
  RepairReport report;
  report.gone = Gone::first;
  const HalfedgeId uw = PlanarMap::twin(wu);
  const ChainNode face = map.node(wu), across = map.node(uw);
  const VertexId v = map.target(uv);
  const HalfedgeId p = map.previous(uw);
  const HalfedgeId third = map.next(uv);
  if (map.next(third) == wu) return without_triangle(map, wu, report);
  const HalfedgeId before = map.previous(wu);
  const HalfedgeId wv = wu, vw = uw;  // the edge is reused
  map.set_origin(vw, v);
  map.set_pinch(vw, false);
  map.link(wv, third);
  map.link(p, uv);
  map.link(uv, vw);
  map.set_node(uv, across);
  mark_pinch(map, face, uv);
  report.repair = Repair::convex_flip;
  for (const HalfedgeId c : {before, wv, p, uv, vw}) report.touch(c);
  return report;
}

/// The near end comes first: h = v -> u, next = u -> w. The edge u -> w is removed, and v -> w is added.
RepairReport near_end_first(PlanarMap& map, HalfedgeId vu, HalfedgeId uw) {
  RepairReport report;
  report.gone = Gone::second;
  const HalfedgeId wu = PlanarMap::twin(uw);
  const ChainNode face = map.node(vu), across = map.node(wu);
  const VertexId v = map.origin(vu);
  const HalfedgeId p = map.previous(wu), n = map.next(wu);
  const HalfedgeId third = map.next(uw);
  if (map.next(third) == vu) return without_triangle(map, uw, report);
  const HalfedgeId before = map.previous(vu);
  const HalfedgeId vw = uw, wv = wu;  // the edge is reused
  map.set_origin(vw, v);
  map.set_pinch(vw, false);
  map.link(before, vw);
  map.link(wv, vu);
  map.link(vu, n);
  map.set_node(vu, across);
  mark_pinch(map, face, vu);
  report.repair = Repair::convex_flip;
  for (const HalfedgeId c : {before, vw, p, wv, vu}) report.touch(c);
  return report;
}

}  // namespace

RepairReport repair_convex(PlanarMap& map, HalfedgeId h, VertexId nearer) {
  const HalfedgeId n = map.next(h);
  const bool far_first = map.target(n) == nearer;
  const HalfedgeId far_edge = far_first ? h : n;
  if (map.is_polygon_edge(far_edge)) {
    RepairReport report;
    report.gone = far_first ? Gone::first : Gone::second;
    report.hitting = nearer;
    report.hit = HalfedgeId(far_edge.value & ~1u);
    return report;
  }
  return far_first ? far_end_first(map, h, n) : near_end_first(map, h, n);
}

}  // namespace taut::internal
