// Polygons whose rings touch at points, as OGC Simple Features allows, cut into parts whose rings do not.
#pragma once

#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {

/// Parts that cover the same points as `part`. If two of its rings touch at points, and nothing worse, the part is cut
/// along segments between its vertices, so that no rings of a part touch. Otherwise it is the
/// only one in the result, as it was. Exact: no vertex is moved, and none is new.
std::vector<Part> cut_where_rings_touch(Part part);

/// +1 if a simple ring runs counterclockwise, -1 if clockwise. Exact.
int ring_direction(const Polygon& ring);

}  // namespace taut::internal
