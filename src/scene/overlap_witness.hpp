// Bodies that overlap at an instant: where their outlines cross, and a point that shows it.
#pragma once

#include <optional>

#include "scene/instance.hpp"
#include "scene/placement.hpp"

namespace taut::internal {

/// A point that certainly lies inside both bodies at time t (not within a jump between two pieces), in world
/// coordinates and in the input's units. The bodies are those that were written, without the displacement. Nothing if
/// none was found: an overlap can be too thin for two doubles. Linear in the number of vertices, except where the
/// overlap is small compared with the bodies.
std::optional<Point> common_point(const BodyPair& bodies, double t);
/// The same of two bodies of a scene, at its start, on any layer that both are on.
std::optional<Point> common_point(const Instance& instance, const std::array<BodyId, 2>& pair);

// Two bodies at one instant: where do their outlines cross?

/// An edge of P and one of Q, each named by its first vertex.
struct EdgePair {
  VertexId p, q;
};

/// Two edges that cross, the first in the order of the sweep; nothing if none do. Exact; about O(n log n), as long as
/// few edges lie one above the other.
std::optional<EdgePair> crossing_edges(const Placement& placement);

}  // namespace taut::internal
