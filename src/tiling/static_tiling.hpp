// The external relative geodesic triangulation, from scratch.
#pragma once

#include <optional>

#include "tiling/free_triangulation.hpp"
#include "tiling/planar_map.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {

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
