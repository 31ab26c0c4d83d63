// The geodesics of all nodes of one chain tree, and the faces between them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tiling/chain_tree.hpp"
#include "tiling/free_triangulation.hpp"
#include "tiling/planar_map.hpp"

namespace taut::internal {

/// Adds a polygon's edges to a map that has only just been reset: its inside is linked and labelled by the leaves.
void add_polygon_edges(const ChainTree& tree, std::uint32_t first_vertex, PlanarMap& map);

/// Adds the faces of all nodes of the tree of P (or Q) to the map and returns the root's geodesic, the relative convex
/// hull, as half-edges in order, polygon on the left. Their twins have no face yet.
///
/// The geodesic of a chain is found in the triangulation: rotate around the chain's inner vertices, collect the
/// diagonals crossed, cancel a diagonal crossed and crossed back, pull the string taut by a funnel. Children are done
/// before their parents, so that a parent's diagonals are those of its children and of the vertex between them.
/// `visitor`, if there is one, is shown every inner node with the vertices of its geodesic.
using GeodesicVisitor = std::function<void(ChainNode, std::span<const VertexId>)>;
std::vector<HalfedgeId> add_geodesic_faces(const Placement& placement, const FreeTriangulation& triangulation,
                                           const ChainTree& tree, std::uint32_t first_vertex, PlanarMap& map,
                                           const GeodesicVisitor& visitor = {});

/// A polygon that contains a body: some subtrees' chains are replaced by their geodesics, which are in the map already.
struct ShapeOutline {
  std::vector<bool> open;                 ///< by heap number: is the node's geodesic still to be found?
  std::vector<std::uint32_t> open_nodes;  ///< those for which it is, by heap number
  std::vector<HalfedgeId> edges;          ///< the polygon's edges, counterclockwise, body on the left
  std::vector<std::uint32_t> leaf_edges;  ///< how many of them stand for each closed subtree, in order
};

/// The same for the open nodes only. The triangulation is that of the space outside the outlines of both bodies, whose
/// vertices are `vertices` of the map; this outline's begin at number `first`.
std::vector<HalfedgeId> add_open_faces(const Placement& outside, const FreeTriangulation& triangulation,
                                       const ChainTree& tree, const ShapeOutline& outline,
                                       const std::vector<VertexId>& vertices, std::uint32_t first, PlanarMap& map);

/// The pinned geodesic cycle of one level of the tree (section 2 of the paper): the geodesics of the nodes of depth
/// `level`, and of the leaves above it, in order around the polygon, each with all its vertices. Level 0 is the
/// relative convex hull. Built from scratch, O(n) per level above `level`.
std::vector<std::vector<VertexId>> geodesics_of_level(const Placement& placement,
                                                      const FreeTriangulation& triangulation, const ChainTree& tree,
                                                      std::uint32_t first_vertex, int level);

}  // namespace taut::internal
