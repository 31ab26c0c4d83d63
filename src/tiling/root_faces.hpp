// The region outside both relative convex hulls: the root pseudo-triangle and the infinite face.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/ids.hpp"
#include "taut/error.hpp"
#include "tiling/free_triangulation.hpp"
#include "tiling/planar_map.hpp"

namespace taut::internal {

class Placement;

/// The four states of the root.
enum class RootState : unsigned char { disjoint, bridged, mouth, pinched };
const char* to_string(RootState state);

/// Merges the edges that the two hulls share, marks pinch edges, adds the root's own edges, and links the two faces.
/// `apart`: the hulls are known to have nothing in common, and the map has the infinite face around each of them.
RootState add_root_faces(const Placement& placement, const std::vector<HalfedgeId>& hull_p,
                         const std::vector<HalfedgeId>& hull_q, PlanarMap& map, bool apart = false);

class Placement;

/// What two relative convex hulls in contact show to the outside. Their contact is one path; RCH(P), walked
/// counterclockwise, leaves it at z_b and comes back to it at z_a.
struct FreeChains {
  std::vector<VertexId> a;  ///< along RCH(P), from z_b counterclockwise to z_a
  std::vector<VertexId> b;  ///< along RCH(Q), from z_b clockwise to z_a
};

/// Where the other end of a bridge is that begins on A.
enum class BridgeEnd : unsigned char { on_b, at_z_a, on_a };

/// The bridge from A's vertex number `from` to number `to` of the chain it ends on.
struct Bridge {
  std::size_t from = 0;
  BridgeEnd end = BridgeEnd::on_b;
  std::size_t to = 0;
};

/// Finds the bridge in time linear in the chains. A must not touch itself.
Bridge find_bridge(const Placement& placement, const FreeChains& chains);

struct StaticTiling {
  PlanarMap map;
  RootState root = RootState::disjoint;
  /// Set if the polygons are not disjoint; the map is empty then.
  std::optional<Overlap> overlap;
};

/// Builds the tiling of a placement, O(n log n). P must be the polygon with the larger diameter, and each polygon's
/// first vertex on its convex hull.
StaticTiling build_tiling(const Placement& placement);

}  // namespace taut::internal
