// The parts of a body: as one shape, without the seams at which they touch or overlap, and as cross-sections, where
// they are on different layers.
#pragma once

#include <cstddef>
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

// Bodies with parts on different layers, as bodies that each have one interval of layers.

/// What a body is at all heights of an interval: the union of these parts.
struct CrossSection {
  Layers z;
  std::vector<std::size_t> parts;  ///< in order
};

/// A body from the lowest interval up; intervals without a part are left out, and neighbours differ. One cross-section
/// if all parts have the same layers. Two bodies meet if and only if two of their cross-sections do whose layers
/// meet().
std::vector<CrossSection> cross_sections_of(const Body& body);

/// Calls visit(layers) for each of the body's parts, in order; once for a body that is one polygon.
template <class Visit>
void for_each_layers(const Body& body, const Visit& visit) {
  for (const Part& part : body.parts) visit(part.z.value_or(body.z));
  for (const CurvedPart& part : body.curves) visit(part.z.value_or(body.z));
  if (body.parts.empty() && body.curves.empty()) visit(body.z);
}
/// All of these.
std::vector<Layers> layers_of_parts(const Body& body);

/// Do any two parts have a layer in common?
bool share_layers(const Body& a, const Body& b);

}  // namespace taut::internal
