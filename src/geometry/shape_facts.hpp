// What scenes need to know of a polygon that depends on nothing else.
#pragma once

#include "geometry/axis_box.hpp"

namespace taut::internal {

struct ShapeFacts {
  std::uint32_t size = 0;         ///< number of vertices
  std::uint32_t first = 0;        ///< the lexicographically smallest vertex, a strict corner of the hull
  bool reversed = false;          ///< the vertices run clockwise
  double least = 0, largest = 0;  ///< magnitudes of the coordinates that are not zero; infinite and 0 if all are
  AxisBox bounds;

  /// Vertex k of the polygon counterclockwise, from `first` on, as an index of the input.
  std::uint32_t vertex(std::uint32_t k) const { return reversed ? (first + size - k) % size : (first + k) % size; }
};

/// The polygon must be valid. O(n).
ShapeFacts facts_of(const Polygon& polygon);

/// The polygon counterclockwise from its first vertex on, in coordinates multiplied by 2^exponent (exact).
std::vector<Point> normalised(const Polygon& polygon, const ShapeFacts& facts, int exponent);

}  // namespace taut::internal
