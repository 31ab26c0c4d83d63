#include "geometry/band.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_tree.hpp"
#include "geometry/predicates.hpp"
#include "numeric/budget.hpp"

namespace taut::internal::curve {
namespace {

struct PlacedCell {
  CellId id;
  std::vector<Point> corners;  ///< counterclockwise; two of a line
};

/// Does the line of edge i of a separate it from b? If the cells share the corner `common`, they may meet there.
bool edge_separates(const std::vector<Point>& a, std::size_t i, const std::vector<Point>& b, const Point* common) {
  const Point &p = a[i], &q = a[(i + 1) % a.size()];
  for (const Point& v : b) {
    const int side = orientation(p, q, v);
    if (side < 0) continue;
    if (side > 0 || !common) return false;
    if (v == *common) continue;
    // On the line, on the other side of the common corner than the edge.
    if (!(p == *common || q == *common)) return false;
    const Point& end = p == *common ? q : p;
    if (cross_sign_exact(*common, v, *common, end) != 0) return false;
    if ((v.x - common->x) * (end.x - common->x) > 0 || (v.y - common->y) * (end.y - common->y) > 0) return false;
  }
  return true;
}

bool separate(const std::vector<Point>& a, const std::vector<Point>& b, const Point* common) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (edge_separates(a, i, b, common)) return true;
  }
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (edge_separates(b, i, a, common)) return true;
  }
  return false;
}

/// All pairs of cells that may meet, of those whose boxes do.
class MeetingSearch {
 public:
  explicit MeetingSearch(const std::vector<const Band*>& bands) : bands_(bands) {
    for (std::size_t b = 0; b < bands.size(); ++b) {
      for (std::size_t k = 0; k < bands[b]->cells().size(); ++k) {
        cells_.push_back({{static_cast<int>(b), static_cast<int>(k)}, bands[b]->corners(k)});
      }
    }
  }

  std::vector<std::array<CellId, 2>> run() {
    std::vector<AxisBox> boxes;
    for (const PlacedCell& cell : cells_) boxes.push_back(box_around(cell.corners));
    BoxTree(boxes).each_two([this](int i, int k) {
      look_at(cells_[static_cast<std::size_t>(std::min(i, k))], cells_[static_cast<std::size_t>(std::max(i, k))]);
    });
    return std::move(found_);
  }

 private:
  void look_at(const PlacedCell& a, const PlacedCell& b) {
    checkpoint();
    if (a.id.band != b.id.band) {
      if (!separate(a.corners, b.corners, nullptr)) found_.push_back({a.id, b.id});
      return;
    }
    const Band& band = *bands_[static_cast<std::size_t>(a.id.band)];
    const int n = static_cast<int>(band.cells().size());
    const bool forwards = (a.id.cell + 1) % n == b.id.cell, backwards = (b.id.cell + 1) % n == a.id.cell;
    bool apart = false;
    if (forwards != backwards) {
      const Gate& gate = band.gate(static_cast<std::size_t>(forwards ? b.id.cell : a.id.cell));
      // Cells that share an edge are on its two sides.
      apart = !gate.exact || separate(a.corners, b.corners, &gate.left);
    } else if (!forwards) {
      apart = separate(a.corners, b.corners, nullptr);
    }
    if (!apart) found_.push_back({a.id, b.id});
  }

  const std::vector<const Band*>& bands_;
  std::vector<PlacedCell> cells_;
  std::vector<std::array<CellId, 2>> found_;
};

}  // namespace

std::vector<std::array<CellId, 2>> meeting_cells(const std::vector<const Band*>& bands) {
  return MeetingSearch(bands).run();
}

}  // namespace taut::internal::curve
