// Tilings from prepared shapes: of a body alone, and of a pair joined from these.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/ids.hpp"
#include "tiling/node_boxes.hpp"
#include "tiling/planar_map.hpp"
#include "tiling/root_faces.hpp"

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

/// The same as build_tiling(placement), given what is known of each body alone, displaced as in the placement.
/// Where the bodies' regions are apart, faces are taken over; only the nodes to whose regions the other body may come
/// near are done anew, on outlines that leave out what the other body cannot reach. What remains to be done per vertex
/// is copying.
/// Nothing if that would not pay, because much of both bodies is near the other, or if the bodies are not disjoint:
/// then the tiling must be built from scratch. With `in_any_case`, also where it does not pay.
std::optional<StaticTiling> join_tilings(const Placement& placement, const ShapeTiling& p, const ShapeTiling& q,
                                         bool in_any_case = false);

class Placement;

/// Boxes cannot decide bodies apart that rest on each other, and parts of both would be tiled anew. But of two convex
/// polygons that are disjoint, one has an edge with the other one beyond it, and doubles find those edges that may be
/// it: then exact orientations decide.
///
/// The hulls are given by their corners, with the body to the left. False if they are not disjoint, or if the few edges
/// that are tried do not show it.
bool hulls_apart(const Placement& placement, const std::vector<VertexId>& hull_p, const std::vector<VertexId>& hull_q);

}  // namespace taut::internal
