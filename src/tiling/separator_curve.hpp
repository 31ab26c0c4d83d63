// Polygonal curves given by doubles, and whether they separate two polygons, exactly.
#pragma once

#include <optional>
#include <vector>

#include "taut/geometry.hpp"
#include "tiling/link_paths.hpp"

namespace taut::internal {

/// A closed polygon, or a chain whose first and last edges go on to infinity: beyond the first vertex, away from the
/// second, and beyond the last one.
struct Curve {
  std::vector<Point> vertices;
  bool closed = false;
  std::size_t edges() const { return closed ? vertices.size() : vertices.size() - 1; }
};

/// Where neighbouring links meet, rounded; an open curve ends well outside `around`.
Curve curve_of(const LinkPath& path, const std::vector<Point>& around);

/// Does the curve avoid the insides of both polygons (it may touch them), and does every path from the one to the
/// other cross it? Exact, O(number of edges times number of vertices). Polygons must be simple and counterclockwise.
bool separates(const Curve& curve, const Polygon& p, const Polygon& q);

}  // namespace taut::internal
