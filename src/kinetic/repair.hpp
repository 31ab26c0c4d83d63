// Restoring the tiling where a certificate failed (Fig. 7 of the paper).
#pragma once

#include <array>
#include <cstdint>

#include "taut/tracer.hpp"
#include "tiling/planar_map.hpp"

namespace taut::internal {

enum class Gone : unsigned char { none, first, second };

/// The action of a repair, and the corners that it may have changed. Each corner is named by its first half-edge.
struct RepairReport {
  Repair repair = Repair::collision;
  /// The edge of the corner that is removed (or would be, if it were not a polygon edge).
  Gone gone = Gone::none;
  bool pinch_rule = false;
  std::array<HalfedgeId, 6> corners{};
  std::uint32_t corner_count = 0;
  /// The edge that was removed permanently, if any; its half-edges are dead.
  HalfedgeId removed;
  /// For a collision: the vertex, and the polygon's own half-edge that it hit.
  VertexId hitting;
  HalfedgeId hit;

  void touch(HalfedgeId h) { corners[corner_count++] = h; }
};

/// The convex corner h -> next(h) has closed: the ends a = origin(h) and b = target(next(h)) lie in one direction from
/// u = target(h), and `nearer` is the nearer one.
RepairReport repair_convex(PlanarMap& map, HalfedgeId h, VertexId nearer);

/// The reflex corner h -> next(h) has straightened.
RepairReport repair_reflex(PlanarMap& map, HalfedgeId h);

}  // namespace taut::internal
