// The region outside both relative convex hulls: the root pseudo-triangle and the infinite face.
#pragma once

#include <string>
#include <vector>

#include "taut/error.hpp"
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

}  // namespace taut::internal
