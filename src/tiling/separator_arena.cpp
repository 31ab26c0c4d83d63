#include "tiling/separator_arena.hpp"

#include "motion/make_segments.hpp"
#include "motion/motion_segment.hpp"
#include "motion/pieces.hpp"
#include "scene/placement.hpp"
#include "tiling/geodesic_faces.hpp"

namespace taut::internal {
namespace {

std::vector<VertexId> relative_hull(const Placement& placement, const FreeTriangulation& triangulation,
                                    const ChainTree& tree, std::uint32_t first_vertex) {
  std::vector<VertexId> hull = geodesics_of_level(placement, triangulation, tree, first_vertex, 0).front();
  hull.pop_back();
  return hull;
}

}  // namespace

std::optional<Arena> make_arena(const Polygon& a, const Polygon& b) {
  Scene scene;
  scene.bodies = {{"a", a, {}}, {"b", b, {}}};
  std::optional<Arena> arena(std::in_place);
  arena->bodies = pair_of(scene);
  std::optional<PairGeometry> geometry = displaced_pair_if_possible(arena->bodies, Offset::inward);
  if (!geometry) return std::nullopt;
  arena->geometry = std::move(*geometry);
  const MotionSegments segments = segments_of(arena->bodies, 0, 0);
  const Placement placement(arena->geometry, segments.front(), 0);
  if (triangulate_free_space(placement, arena->triangulation, true)) return std::nullopt;
  const PairGeometry& g = arena->geometry;
  for (const SharedPolygon& polygon : {g.p(), g.q()}) {
    for (const DisplacedPoint& v : polygon->points) arena->points.push_back({v.x, v.y});
  }
  for (unsigned i = 0; i < 4; ++i) arena->points.push_back(placement.approximate(placement.box_corner(i)));
  const ChainTree tree_p(g.np, node::p_tree), tree_q(g.nq, node::q_tree);
  arena->hulls[0] = relative_hull(placement, arena->triangulation, tree_p, 0);
  arena->hulls[1] = relative_hull(placement, arena->triangulation, tree_q, g.np);
  return arena;
}

}  // namespace taut::internal
