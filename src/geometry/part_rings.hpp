// The rings of a part: do they lie as they must, which of them are holes, and where do they touch?
#pragma once

#include <string>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/outline.hpp"

namespace taut::internal {

// Do the rings of a part lie as they must?

/// Throws InputError unless the closed inside of every hole lies in the inside of the outline, and no two of them
/// touch. The rings must be valid polygons. Exact; about O(n log n) where few edges lie one above the other. `name` is
/// the body's, and part's, in messages; holes are counted from 1.
void validate_holes(const Part& part, const std::string& name);

}  // namespace taut::internal

namespace taut::internal::curve {

// Which subpath is an outline, and which a hole?

/// The parts that the rings enclose by the rule; rings with the same on both sides bound nothing and are left out.
/// Throws InputError where rings meet.
std::vector<CurvedPart> nested(const std::vector<Outline>& rings, FillRule rule, const std::string& name);

}  // namespace taut::internal::curve

namespace taut::internal {

// Polygons whose rings touch at points, as OGC Simple Features allows, cut into parts whose rings do not.

/// Parts that cover the same points as `part`. If two of its rings touch at points, and nothing worse, the part is cut
/// along segments between its vertices, so that no rings of a part touch. Otherwise it is the
/// only one in the result, as it was. Exact: no vertex is moved, and none is new.
std::vector<Part> cut_where_rings_touch(Part part);

/// +1 if a simple ring runs counterclockwise, -1 if clockwise. Exact.
int ring_direction(const Polygon& ring);

}  // namespace taut::internal
