#include "scene/free_cells.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal {
namespace {

/// Boundaries are drawn wider by this on all sides; coordinates are at most 1.
constexpr double drawn_wider = 0x1p-30;
/// Cells along the longer side.
constexpr double fewest_cells = 128, most_cells = 1024, cells_by_edges = 16;

constexpr std::uint8_t value_of(FreeCells::Cell cell) { return static_cast<std::uint8_t>(cell); }

}  // namespace

FreeCells::FreeCells(const std::vector<SharedRings>& bodies) {
  std::vector<BoundaryEdge> edges;
  std::vector<AxisBox> outlines;
  lo_x_ = lo_y_ = INFINITY;
  hi_x_ = hi_y_ = -INFINITY;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const DisplacedPolygon& body = *bodies[k]->displaced(Offset::inward);
    for (const RingSpan& ring : rings_of(body)) {
      for (std::uint32_t i = 0; i < ring.count; ++i) {
        const DisplacedPoint &a = body.points[ring.first + i], &b = body.points[ring.first + (i + 1) % ring.count];
        edges.push_back({a.x, a.y, b.x, b.y});
        lo_x_ = std::min(lo_x_, a.x - 2 * drawn_wider);
        lo_y_ = std::min(lo_y_, a.y - 2 * drawn_wider);
        hi_x_ = std::max(hi_x_, a.x + 2 * drawn_wider);
        hi_y_ = std::max(hi_y_, a.y + 2 * drawn_wider);
      }
      if (ring.hole) continue;
      const DisplacedPoint& v = body.points[ring.first];
      outlines.push_back({v.x - drawn_wider, v.y - drawn_wider, v.x + drawn_wider, v.y + drawn_wider});
      outline_of_.push_back(static_cast<int>(k));
    }
  }
  outlines_ = BoxTree(outlines);
  if (edges.empty()) return;
  const double side = std::max(hi_x_ - lo_x_, hi_y_ - lo_y_);
  cell_ = side / std::clamp(cells_by_edges * std::sqrt(static_cast<double>(edges.size())), fewest_cells, most_cells);
  per_cell_ = 1 / cell_;
  width_ = static_cast<std::size_t>((hi_x_ - lo_x_) / cell_) + 1;
  height_ = static_cast<std::size_t>((hi_y_ - lo_y_) / cell_) + 1;
  fill(edges);
  for (const BoundaryEdge& edge : edges) draw(edge);
  measure();
}

/// Row by row: how often the bodies wind around the middles of cells, by the edges that cross the row's middle line.
/// Middles that boundaries come near to may be wrong: these cells are not free anyway.
void FreeCells::fill(const std::vector<BoundaryEdge>& edges) {
  cells_.assign(width_ * height_, value_of(Cell::free));
  std::vector<std::vector<std::pair<double, int>>> rows(height_);
  for (const BoundaryEdge& e : edges) {
    const double low = std::min(e.ay, e.by), high = std::max(e.ay, e.by);
    const double first = std::max(0.0, std::floor((low - lo_y_) * per_cell_) - 1);
    for (auto j = static_cast<std::size_t>(first); j < height_; ++j) {
      const double y = lo_y_ + (static_cast<double>(j) + 0.5) * cell_;
      if (y > high) break;
      if ((e.ay > y) == (e.by > y)) continue;
      rows[j].emplace_back(e.ax + (y - e.ay) / (e.by - e.ay) * (e.bx - e.ax), e.ay > y ? 1 : -1);
    }
  }
  for (std::size_t j = 0; j < height_; ++j) {
    std::sort(rows[j].begin(), rows[j].end());
    int winds = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < width_; ++i) {
      const double x = lo_x_ + (static_cast<double>(i) + 0.5) * cell_;
      for (; next < rows[j].size() && rows[j][next].first < x; ++next) winds += rows[j][next].second;
      if (winds > 0) cells_[j * width_ + i] = value_of(Cell::covered);
    }
  }
}

/// No cell that the edge comes near to is free: of each row, those between the edge's places at its borders.
void FreeCells::draw(const BoundaryEdge& e) {
  const bool up = e.ay <= e.by;
  const double x0 = up ? e.ax : e.bx, y0 = up ? e.ay : e.by, x1 = up ? e.bx : e.ax, y1 = up ? e.by : e.ay;
  const auto row = [this](double y) {
    return static_cast<std::size_t>(std::clamp((y - lo_y_) * per_cell_, 0.0, static_cast<double>(height_ - 1)));
  };
  const auto column = [this](double x) {
    return static_cast<std::size_t>(std::clamp((x - lo_x_) * per_cell_, 0.0, static_cast<double>(width_ - 1)));
  };
  const double wider = drawn_wider + 0x1p-20 * cell_;
  for (std::size_t j = row(y0 - wider); j <= row(y1 + wider); ++j) {
    const double low = std::clamp(lo_y_ + static_cast<double>(j) * cell_ - 2 * wider, y0, y1);
    const double high = std::clamp(lo_y_ + static_cast<double>(j + 1) * cell_ + 2 * wider, y0, y1);
    double from = x0, to = x1;
    if (y1 > y0) {
      from = x0 + (low - y0) / (y1 - y0) * (x1 - x0);
      to = x0 + (high - y0) / (y1 - y0) * (x1 - x0);
    }
    const std::size_t last = column(std::max(from, to) + 2 * wider);
    for (std::size_t i = column(std::min(from, to) - 2 * wider); i <= last; ++i)
      cells_[j * width_ + i] = value_of(Cell::mixed);
  }
}

/// Adds to each free cell its distance in cells, along the axes and diagonally, from the next one that is not free, by
/// two sweeps. What is outside of the grid is free.
void FreeCells::measure() {
  constexpr std::uint8_t free = value_of(Cell::free), farthest = 255 - free;
  for (std::uint8_t& cell : cells_) cell = cell == free ? 255 : cell;
  const auto nearer = [this](std::size_t at, std::size_t i, std::ptrdiff_t row, bool below) {
    const auto distance = [&](std::ptrdiff_t to) -> int {
      const std::uint8_t value = cells_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + to)];
      return value < free ? 0 : value - free;
    };
    int least = farthest;
    const std::ptrdiff_t step = row < 0 ? -1 : 1;
    if (step < 0 ? i > 0 : i + 1 < width_) least = std::min(least, distance(step) + 1);
    if (below) {
      least = std::min(least, distance(row) + 1);
      if (i > 0) least = std::min(least, distance(row - 1) + 1);
      if (i + 1 < width_) least = std::min(least, distance(row + 1) + 1);
    }
    cells_[at] = static_cast<std::uint8_t>(std::min<int>(cells_[at], free + least));
  };
  const auto row = static_cast<std::ptrdiff_t>(width_);
  for (std::size_t at = 0; at < cells_.size(); ++at) {
    if (cells_[at] >= free) nearer(at, at % width_, -row, at >= width_);
  }
  for (std::size_t at = cells_.size(); at-- > 0;) {
    if (cells_[at] >= free) nearer(at, at % width_, row, at + width_ < cells_.size());
  }
}

void FreeCells::outlines_in(const AxisBox& box, std::vector<int>& bodies) const {
  const auto begin = static_cast<std::ptrdiff_t>(bodies.size());
  outlines_.find(box, bodies);
  for (auto k = bodies.begin() + begin; k != bodies.end(); ++k) *k = outline_of_[static_cast<std::size_t>(*k)];
  std::sort(bodies.begin() + begin, bodies.end());
  bodies.erase(std::unique(bodies.begin() + begin, bodies.end()), bodies.end());
}

}  // namespace taut::internal
