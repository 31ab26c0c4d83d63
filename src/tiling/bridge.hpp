// The bridge over the corner between two relative convex hulls that touch.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/ids.hpp"

namespace taut::internal {

class Placement;

/// What two relative convex hulls in contact show to the outside. Their contact is one path; RCH(P), walked
/// counterclockwise, leaves it at z_b and comes back to it at z_a.
struct FreeChains {
  std::vector<VertexId> a;  ///< along RCH(P), from z_b counterclockwise to z_a
  std::vector<VertexId> b;  ///< along RCH(Q), from z_b clockwise to z_a
};

/// Where the other end of a bridge is that begins on A.
enum class BridgeEnd : unsigned char { on_b, at_z_a, on_a };

/// The bridge from A's vertex number `from` to number `to` of the chain it ends on.
struct Bridge {
  std::size_t from = 0;
  BridgeEnd end = BridgeEnd::on_b;
  std::size_t to = 0;
};

/// Finds the bridge in time linear in the chains. A must not touch itself.
Bridge find_bridge(const Placement& placement, const FreeChains& chains);

}  // namespace taut::internal
