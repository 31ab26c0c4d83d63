// Which of many edges cross a segment: edges are kept in the cells of a grid.
#pragma once

#include <vector>

#include "taut/geometry.hpp"

namespace taut::paper {

class EdgeGrid {
 public:
  /// For edges between these points, which must outlive it.
  explicit EdgeGrid(const std::vector<Point>& points);

  void add(int from, int to);
  /// Whether an edge has a point in common with the segment, other than a common end. Exact.
  bool is_crossed(int from, int to) const;

 private:
  template <class Visit>
  bool any_cell(int from, int to, const Visit& visit) const;
  const Point& at(int v) const { return points_[static_cast<std::size_t>(v)]; }
  bool cross(int a, int b, int c, int d) const;
  int column(double x) const;
  int row(double y) const;

  const std::vector<Point>& points_;
  double left_ = 0, bottom_ = 0, cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::pair<int, int>>> cells_;
};

}  // namespace taut::paper
