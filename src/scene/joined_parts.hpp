// The parts of a body as one shape: without the seams at which they touch or overlap.
#pragma once

#include <optional>
#include <vector>

#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// A ring of a union of parts: of each vertex the nearest vertex of the body, and the body's edge that leaves from it.
struct JoinedRing {
  Polygon points;  ///< counterclockwise, also of a hole
  std::vector<VertexRef> vertices;
  std::vector<EdgeRef> edges;
};

/// A connected piece of it.
struct JoinedPart {
  JoinedRing outline;
  std::vector<JoinedRing> holes;
};

/// The union of the parts of a body, some of which touch or overlap; nothing if none do. Edges lie within `tolerance`
/// of the union's boundary, and parts that come closer to each other than an eighth of that count as touching.
///
/// Parts are grown by about a sixteenth of the tolerance, each edge by a random share of it: then those that touch
/// overlap, no three edges meet in a point, and the union is exact. Seams end in steps as high as that; vertices next
/// to edges shorter than the tolerance go, if the boundary stays within it. Throws InputError where a part is thinner
/// than the tolerance. The body must be valid, and the tolerance at least 2^-46 of its coordinates.
std::optional<std::vector<JoinedPart>> joined_parts(const Body& body, BodyId id, double tolerance);

}  // namespace taut::internal
