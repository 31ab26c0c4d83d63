// Cells near a polygon at rest.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {

/// Collects cells, each once. A cell is a square of side 1 here: coordinates are in cells.
class CellRaster {
 public:
  /// Rings of one body, placed; `margin` > 0. Adds every cell that is at most `margin` away from the body, and none
  /// that is more than margin + slack away. The slack covers the rounding of coordinates of that magnitude. Throws
  /// InputError where there are too many.
  void add(const std::vector<std::vector<Polygon>>& parts, double margin, double slack);

  /// By rows, then columns.
  std::vector<std::array<int, 2>> sorted() const;

 private:
  void add_edge(const Point& a, const Point& b, double margin);
  void add_inside(const std::vector<Polygon>& rings);
  void mark(int i, int j);

  std::unordered_set<std::uint64_t> marked_;
};

}  // namespace taut::internal
