// What must hold of every tiling: used by tests and audits.
#pragma once

#include <string>
#include <vector>

#include "tiling/planar_map.hpp"

namespace taut::internal {

class Placement;

/// Checks that links are consistent, every free face is a pseudo-triangle (three convex corners; the infinite face has
/// one), no node has two faces, angles close up around every vertex, and Euler's formula holds. Returns what is wrong,
/// or an empty string.
std::string find_fault(const PlanarMap& map, const Placement& placement);

/// A map in a form that can be compared: one entry per half-edge, sorted.
struct CanonicalHalfedge {
  std::uint32_t from, to, then, node, pinch;
  friend bool operator==(const CanonicalHalfedge& a, const CanonicalHalfedge& b) {
    return a.from == b.from && a.to == b.to && a.then == b.then && a.node == b.node && a.pinch == b.pinch;
  }
  friend bool operator<(const CanonicalHalfedge& a, const CanonicalHalfedge& b) {
    if (a.from != b.from) return a.from < b.from;
    if (a.to != b.to) return a.to < b.to;
    return a.then < b.then;
  }
};
std::vector<CanonicalHalfedge> canonical(const PlanarMap& map);

/// The first differences between two maps, in words; empty if they are equal, labels and pinch edges included.
std::string difference(const PlanarMap& a, const PlanarMap& b);

}  // namespace taut::internal
