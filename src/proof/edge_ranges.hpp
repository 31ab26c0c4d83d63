// A body's edges, halved again and again: the ranges that a log of separations speaks of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/displacement.hpp"
#include "geometry/vector.hpp"

namespace taut::internal::proof {

/// Some edges, and a rectangle that certainly contains all of them as displaced: all centre + s along + t
/// turned(along) with |s| <= half_length and |t| <= half_width.
struct EdgeRange {
  Vector centre, along;  ///< along is a unit vector up to rounding
  double half_length = 0, half_width = 0;
  std::uint32_t first = 0, count = 0;  ///< of a run of edges: the first one's first vertex, and how many
  std::uint32_t halves[2] = {0, 0};    ///< unused where count is 1

  bool single() const { return count == 1; }
  /// How far its points are from the centre, at most.
  double radius() const { return half_length + half_width; }
};

/// A tree of ranges. Several rings are halved by their order along the longer side of the box around them, a ring by
/// the order of its edges: docs/proof-format.md. Nothing of this is taken from an engine.
class EdgeRanges {
 public:
  explicit EdgeRanges(const DisplacedPolygon& body);
  static constexpr std::uint32_t all = 0;
  const EdgeRange& operator[](std::uint32_t i) const { return ranges_[i]; }

 private:
  std::uint32_t add_rings(const DisplacedPolygon& body, std::span<RingSpan> rings);
  std::uint32_t add_run(const DisplacedPolygon& body, const RingSpan& ring, std::uint32_t first, std::uint32_t count);

  std::vector<EdgeRange> ranges_;
};

}  // namespace taut::internal::proof
