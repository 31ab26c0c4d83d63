#include "comparison/edge_grid.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"

namespace taut::paper {

EdgeGrid::EdgeGrid(const std::vector<Point>& points) : points_(points) {
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.x < b.x; });
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.y < b.y; });
  left_ = left->x;
  bottom_ = low->y;
  const double width = right->x - left_, height = high->y - bottom_;
  // About one point a cell.
  cell_ = std::max(std::sqrt(width * height / static_cast<double>(points.size())), std::max(width, height) / 1000);
  columns_ = static_cast<int>(width / cell_) + 1;
  rows_ = static_cast<int>(height / cell_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

int EdgeGrid::column(double x) const { return std::clamp(static_cast<int>((x - left_) / cell_), 0, columns_ - 1); }
int EdgeGrid::row(double y) const { return std::clamp(static_cast<int>((y - bottom_) / cell_), 0, rows_ - 1); }

/// Calls visit for each cell that the segment may pass, until it returns true.
template <class Visit>
bool EdgeGrid::any_cell(int from, int to, const Visit& visit) const {
  Point a = at(from), b = at(to);
  if (b.x < a.x) std::swap(a, b);
  const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0, slack = 1e-9 * cell_;
  for (int i = column(a.x); i <= column(b.x); ++i) {
    double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
    if (b.x - a.x > cell_) {
      const double x = left_ + i * cell_, y = a.y + slope * (x - a.x), z = y + slope * cell_;
      low = std::max(low, std::min(y, z) - slack);
      high = std::min(high, std::max(y, z) + slack);
    }
    for (int j = row(low - slack); j <= row(high + slack); ++j)
      if (visit(static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)))
        return true;
  }
  return false;
}

void EdgeGrid::add(int from, int to) {
  any_cell(from, to, [&](std::size_t cell) {
    cells_[cell].emplace_back(from, to);
    return false;
  });
}

bool EdgeGrid::cross(int a, int b, int c, int d) const {
  if (a == c || a == d || b == c || b == d) return false;
  const auto side = [&](int u, int v, int w) { return internal::orientation(at(u), at(v), at(w)); };
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

bool EdgeGrid::is_crossed(int from, int to) const {
  return any_cell(from, to, [&](std::size_t cell) {
    return std::any_of(cells_[cell].begin(), cells_[cell].end(),
                       [&](const auto& edge) { return cross(from, to, edge.first, edge.second); });
  });
}

}  // namespace taut::paper
