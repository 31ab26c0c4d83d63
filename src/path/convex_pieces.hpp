// A polygon with holes as a union of convex polygons, without new vertices.
#pragma once

#include <optional>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/outline.hpp"

namespace taut::internal::path {

/// Counterclockwise convex polygons whose interiors are disjoint and whose union is the part, exactly: by cutting off
/// ears, and joining what is convex together. Nothing if there are too many vertices, or it does not work out. The part
/// must be valid.
std::optional<std::vector<Polygon>> convex_pieces(const Part& part);

}  // namespace taut::internal::path
