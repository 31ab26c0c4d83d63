// What can be known of a body's part of the tiling before the other body is: its own geodesics.
#pragma once

#include <memory>
#include <vector>

#include "tiling/node_boxes.hpp"
#include "tiling/planar_map.hpp"

namespace taut::internal {

/// The tiling of a body alone in the plane: the geodesics of its chains, in the role of P or of Q. Where the other body
/// does not come near, the tiling of a pair is the same.
struct ShapeTiling {
  ChainTree tree;
  PlanarMap map;                 ///< the body's vertices are 0 .. n-1; without unused edges
  std::vector<HalfedgeId> hull;  ///< the root's geodesic, body on the left; the infinite face on its other side
  std::vector<HalfedgeId> face;  ///< by heap number: a half-edge of the node's face, if it has one
  std::vector<NodeBox> boxes;    ///< by heap number: around the region between the chain and its geodesic
  std::vector<bool> by_itself;   ///< by heap number: the geodesic passes no vertex twice, and none beyond its chain
};

/// A polygon as displaced for the role; `root` is node::p_tree or node::q_tree. O(n log n).
/// Nothing if the displaced boundary is not simple.
std::unique_ptr<const ShapeTiling> tile_shape(const SharedPolygon& polygon, ChainNode root);

}  // namespace taut::internal
