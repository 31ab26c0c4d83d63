// The union of closed rings in general position.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {

/// A vertex of a union's boundary: one of a ring, or where two edges cross, rounded.
struct UnionVertex {
  Point at;
  std::uint32_t ring = 0, edge = 0;  ///< the edge of a ring that leaves from here, by its first vertex
};

/// The boundary of the points that the rings wind around at least once in sum, with these points to the left of it.
struct RingUnion {
  std::vector<std::vector<UnionVertex>> rings;
  bool changed = false;  ///< it is not just the rings themselves
};

/// Outlines run counterclockwise and holes clockwise; a ring may cross itself and others. Exact but for the rounding of
/// crossings. Nothing if the rings are not in general position: three edges meet in a point, or a vertex lies on an
/// edge.
std::optional<RingUnion> union_of(const std::vector<Polygon>& rings);

}  // namespace taut::internal
