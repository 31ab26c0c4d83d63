// Two bodies at one instant: where do their outlines cross?
#pragma once

#include <optional>

#include "scene/placement.hpp"

namespace taut::internal {

/// An edge of P and one of Q, each named by its first vertex.
struct EdgePair {
  VertexId p, q;
};

/// Two edges that cross, the first in the order of the sweep; nothing if none do. Exact; about O(n log n), as long as
/// few edges lie one above the other.
std::optional<EdgePair> crossing_edges(const Placement& placement);

}  // namespace taut::internal
