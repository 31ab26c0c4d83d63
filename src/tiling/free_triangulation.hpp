// A triangulation of the free space between the two polygons, inside a large box.
#pragma once

#include <optional>
#include <vector>

#include "scene/placement.hpp"

namespace taut::internal {

/// Why two polygons are not disjoint: an edge of each that cross, or one polygon inside the other (then the edges are
/// an edge at the leftmost vertex of the inner one, and the edge of the outer one just below it).
struct Overlap {
  VertexId edge_p, edge_q;  ///< named by their first vertices
};

/// Triangle t has the half-edges 3t, 3t+1, 3t+2, counterclockwise.
struct FreeTriangulation {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::vector<VertexId> origin;
  std::vector<std::uint32_t> twin;      ///< `none` along polygon and box edges
  std::vector<std::uint32_t> boundary;  ///< of polygon edge v: the half-edge next(v) -> v in free space

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  VertexId target(std::uint32_t h) const { return origin[next(h)]; }
};

/// Triangulates by a plane sweep, O(n log n); returns the overlap instead if the polygons are not disjoint.
/// (Hertel and Mehlhorn's sweep: each free interval of the sweep line keeps a reflex chain of vertices that wait for
/// triangles; every new vertex closes what it can see.)
/// With `check_bodies` it also finds edges of one polygon that cross: separators take polygons whose edges may.
std::optional<Overlap> triangulate_free_space(const Placement& placement, FreeTriangulation& result,
                                              bool check_bodies = false);

}  // namespace taut::internal
