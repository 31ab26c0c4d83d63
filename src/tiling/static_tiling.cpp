#include "tiling/static_tiling.hpp"

#include "tiling/geodesic_faces.hpp"

namespace taut::internal {

StaticTiling build_tiling(const Placement& placement) {
  StaticTiling result;
  FreeTriangulation triangulation;
  const PairGeometry& g = placement.geometry();
  result.overlap = triangulate_free_space(placement, triangulation);
  if (result.overlap) return result;
  result.map.reset(g.size());
  const ChainTree tree_p(g.np, node::p_tree), tree_q(g.nq, node::q_tree);
  add_polygon_edges(tree_p, 0, result.map);
  add_polygon_edges(tree_q, g.np, result.map);
  const auto hull_p = add_geodesic_faces(placement, triangulation, tree_p, 0, result.map);
  const auto hull_q = add_geodesic_faces(placement, triangulation, tree_q, g.np, result.map);
  result.root = add_root_faces(placement, hull_p, hull_q, result.map);
  return result;
}

}  // namespace taut::internal
