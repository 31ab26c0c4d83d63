// Simple polygons cut into triangles and into convex pieces, for libraries that know only convex shapes.
#pragma once

#include <array>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::bench {

/// Indices of three vertices, counterclockwise.
using Triangle = std::array<int, 3>;

/// Triangles that cover a simple polygon (in either orientation) without overlap: ears are cut off, the shortest
/// diagonal first. Vertices in the middle of a straight line may lie on a triangle's edge. O(n r), r reflex vertices.
std::vector<Triangle> triangulate(const Polygon& polygon);

/// Strictly convex pieces of at most `most` vertices, counterclockwise, that cover the polygon without overlap:
/// triangles, joined across their longest common edges as long as the result is convex (Hertel and Mehlhorn).
std::vector<Polygon> convex_pieces(const Polygon& polygon, std::size_t most);

}  // namespace taut::bench
