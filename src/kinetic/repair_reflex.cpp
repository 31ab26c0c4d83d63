// Repairs at a reflex corner that has straightened.
#include "kinetic/repair.hpp"
#include "numeric/errors.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {
namespace {

/// The tree node that represents the face on the left of h in the joined tree.
ChainNode tree_node(const PlanarMap& map, HalfedgeId h, ChainNode infinite_as) {
  const ChainNode n = map.node(h);
  return n == node::infinite_face ? infinite_as : n;
}

/// An edge stays pinched only while faces of P lie on both its sides.
void unpinch(PlanarMap& map, HalfedgeId h) {
  if (map.is_pinch(h) && !(node::in_p(map.node(h)) && node::in_p(map.node(PlanarMap::twin(h))))) {
    map.set_pinch(h, false);
  }
}

/// Case (b): B comes between. The edge v -> w is removed, and u -> w is added. The edge u -> v now bounds B.
RepairReport replace_second(PlanarMap& map, HalfedgeId uv, HalfedgeId vw) {
  RepairReport report;
  report.repair = Repair::reflex_right;
  report.gone = Gone::second;
  const HalfedgeId p = map.previous(uv), x = map.next(PlanarMap::twin(vw)), y = map.previous(PlanarMap::twin(vw));
  const HalfedgeId uw = vw, wu = PlanarMap::twin(vw);  // the edge is reused
  map.set_origin(uw, map.origin(uv));
  map.set_pinch(uw, false);
  map.link(p, uw);
  map.link(wu, uv);
  map.link(uv, x);
  map.set_node(uv, map.node(wu));
  unpinch(map, uv);
  for (const HalfedgeId c : {p, uw, y, wu, uv}) report.touch(c);
  return report;
}

/// Case (c): A comes between. The edge u -> v is removed, and u -> w is added. The edge v -> w now bounds A.
RepairReport replace_first(PlanarMap& map, HalfedgeId uv, HalfedgeId vw) {
  RepairReport report;
  report.repair = Repair::reflex_left;
  report.gone = Gone::first;
  const HalfedgeId vu = PlanarMap::twin(uv), p = map.previous(uv), n = map.next(vw), x = map.previous(vu);
  const VertexId w = map.target(vw);
  const HalfedgeId uw = uv, wu = vu;  // the edge is reused
  map.set_origin(wu, w);
  map.set_pinch(uw, false);
  map.link(uw, n);
  map.link(x, vw);
  map.link(vw, wu);
  map.set_node(vw, map.node(wu));
  unpinch(map, vw);
  for (const HalfedgeId c : {p, uw, x, vw, wu}) report.touch(c);
  return report;
}

/// Case (a): the triangle u, v, w is the new face of node m.
RepairReport new_face(PlanarMap& map, HalfedgeId uv, HalfedgeId vw, ChainNode m) {
  RepairReport report;
  report.repair = Repair::reflex_new_face;
  const HalfedgeId p = map.previous(uv), n = map.next(vw);
  const HalfedgeId uw = map.add_edge(map.origin(uv), map.target(vw)), wu = PlanarMap::twin(uw);
  map.set_node(uw, map.node(uv));
  map.link(p, uw);
  map.link(uw, n);
  for (const HalfedgeId h : {uv, vw, wu}) map.set_node(h, m);
  map.link(uv, vw);
  map.link(vw, wu);
  map.link(wu, uv);
  for (const HalfedgeId c : {p, uw, uv, vw, wu}) report.touch(c);
  return report;
}

}  // namespace

RepairReport repair_reflex(PlanarMap& map, HalfedgeId uv) {
  const HalfedgeId vw = map.next(uv), vu = PlanarMap::twin(uv), wv = PlanarMap::twin(vw);
  const ChainNode face = map.node(uv), a = map.node(vu), b = map.node(wv);
  // F counts as inf_o if f is F itself, or if f is a face of P with A = PT and B = F; else as inf_i.
  const ChainNode nf = tree_node(map, uv, node::outer_infinite);
  const ChainNode na = tree_node(map, vu, node::inner_infinite);
  const bool outer = node::in_p(face) && a == node::root;
  const ChainNode nb = b == node::infinite_face ? (outer ? node::outer_infinite : node::inner_infinite) : b;
  const bool pinch_first = map.is_pinch(uv), pinch_second = map.is_pinch(vw);
  const ChainNode m = pinch_first ? nb : (pinch_second ? na : node::median(nf, na, nb));
  if (m == nf) throw StructureError("reflex failure: the face itself comes between its neighbours");
  const bool second = m == nb, first = !second && m == na;
  if ((second && map.is_polygon_edge(vw)) || (first && map.is_polygon_edge(uv)))
    throw StructureError("reflex failure: a polygon edge would go");
  if (!second && !first && m.code < 4) throw StructureError("reflex failure: a new face at the root");
  RepairReport report =
      second ? replace_second(map, uv, vw) : (first ? replace_first(map, uv, vw) : new_face(map, uv, vw, m));
  report.pinch_rule = pinch_first || pinch_second;
  return report;
}

}  // namespace taut::internal
