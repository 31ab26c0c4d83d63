#include "query/cell_raster.hpp"

#include <algorithm>
#include <cmath>

#include "taut/error.hpp"

namespace taut::internal {
namespace {

constexpr std::size_t most_marked = std::size_t{1} << 26;
constexpr double farthest_cell = 0x1p30;

int cell_of(double x) {
  if (!(std::fabs(x) < farthest_cell))
    throw InputError("cells", "the body goes beyond 2^30 cells from the grid's origin",
                     "choose larger cells, or an origin nearer to the body");
  return static_cast<int>(std::floor(x));
}

double squared_to_segment(const Point& p, const Point& a, const Point& b) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = p.x - a.x, vy = p.y - a.y;
  const double square = ux * ux + uy * uy;
  const double share = square > 0 ? std::clamp((vx * ux + vy * uy) / square, 0.0, 1.0) : 0;
  const double dx = vx - share * ux, dy = vy - share * uy;
  return dx * dx + dy * dy;
}

double squared_to_cell(const Point& p, double x, double y) {
  const double dx = std::max({x - p.x, 0.0, p.x - (x + 1)}), dy = std::max({y - p.y, 0.0, p.y - (y + 1)});
  return dx * dx + dy * dy;
}

/// Is the cell with its lower left corner at (x, y) at most that far from the segment?
bool near_segment(double x, double y, const Point& a, const Point& b, double margin) {
  const double square = margin * margin;
  if (squared_to_cell(a, x, y) <= square || squared_to_cell(b, x, y) <= square) return true;
  const Point corners[4] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
  int left = 0;
  for (const Point& c : corners) {
    if (squared_to_segment(c, a, b) <= square) return true;
    if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0) ++left;
  }
  // No end is near and no corner is: it is only near if it goes through, with corners on both sides of it.
  return left > 0 && left < 4 && std::max(a.x, b.x) >= x && std::min(a.x, b.x) <= x + 1 && std::max(a.y, b.y) >= y &&
         std::min(a.y, b.y) <= y + 1;
}

}  // namespace

void CellRaster::mark(int i, int j) {
  marked_.insert(static_cast<std::uint64_t>(static_cast<std::uint32_t>(j)) << 32 | static_cast<std::uint32_t>(i));
  if (marked_.size() > most_marked)
    throw InputError("cells", "there are more than 2^26 cells", "choose larger ones, or a shorter motion");
}

/// Row by row, the cells that the segment, made wider, may come to; each is tested.
void CellRaster::add_edge(const Point& a, const Point& b, double margin) {
  const Point &low = a.y <= b.y ? a : b, &high = a.y <= b.y ? b : a;
  const double rise = high.y - low.y;
  for (int j = cell_of(low.y - margin); j <= cell_of(high.y + margin); ++j) {
    const double from = std::clamp(j - margin, low.y, high.y), to = std::clamp(j + 1 + margin, low.y, high.y);
    // On a segment that hardly rises, all of it is in the row.
    const bool flat = !(rise > 0x1p-20);
    const double x0 = flat ? low.x : low.x + (from - low.y) / rise * (high.x - low.x);
    const double x1 = flat ? high.x : low.x + (to - low.y) / rise * (high.x - low.x);
    const int last = cell_of(std::max(x0, x1) + 2 * margin);
    for (int i = cell_of(std::min(x0, x1) - 2 * margin); i <= last; ++i) {
      if (near_segment(i, j, a, b, margin)) mark(i, j);
    }
  }
}

/// Cells whose middles are inside. Those with a middle on the boundary are near it, and marked already.
void CellRaster::add_inside(const std::vector<Polygon>& rings) {
  double lo = INFINITY, hi = -INFINITY;
  for (const Point& p : rings[0]) {
    lo = std::min(lo, p.y);
    hi = std::max(hi, p.y);
  }
  std::vector<double> crossings;
  for (int j = cell_of(lo); j <= cell_of(hi); ++j) {
    const double y = j + 0.5;
    crossings.clear();
    for (const Polygon& ring : rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
        if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const int last = cell_of(crossings[k + 1] - 0.5);
      for (int i = cell_of(std::ceil(crossings[k] - 0.5)); i <= last; ++i) mark(i, j);
    }
  }
}

void CellRaster::add(const std::vector<std::vector<Polygon>>& parts, double margin, double slack) {
  for (const std::vector<Polygon>& rings : parts) {
    for (const Polygon& ring : rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) add_edge(ring[k], ring[(k + 1) % ring.size()], margin + slack);
    }
    add_inside(rings);
  }
}

std::vector<std::array<int, 2>> CellRaster::sorted() const {
  std::vector<std::array<int, 2>> cells;
  cells.reserve(marked_.size());
  for (const std::uint64_t key : marked_)
    cells.push_back({static_cast<int>(static_cast<std::uint32_t>(key)), static_cast<int>(key >> 32)});
  std::sort(cells.begin(), cells.end(),
            [](const auto& a, const auto& b) { return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0]; });
  return cells;
}

}  // namespace taut::internal
