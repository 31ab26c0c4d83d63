#include "curve/meeting_cells.hpp"

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"
#include "geometry/predicates.hpp"

namespace taut::curve {
namespace {

struct CellBox {
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;
  void add(const Point& p) {
    lo_x = std::min(lo_x, p.x);
    lo_y = std::min(lo_y, p.y);
    hi_x = std::max(hi_x, p.x);
    hi_y = std::max(hi_y, p.y);
  }
  void add(const CellBox& b) {
    add(Point{b.lo_x, b.lo_y});
    add(Point{b.hi_x, b.hi_y});
  }
  bool meets(const CellBox& b) const { return lo_x <= b.hi_x && b.lo_x <= hi_x && lo_y <= b.hi_y && b.lo_y <= hi_y; }
};

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

/// All pairs of boxes of a list that meet, where neighbours in the list tend to be neighbours in the plane.
class MeetingSearch {
 public:
  explicit MeetingSearch(const std::vector<const Band*>& bands) : bands_(bands) {
    for (std::size_t b = 0; b < bands.size(); ++b) {
      for (std::size_t k = 0; k < bands[b]->cells().size(); ++k) {
        cells_.push_back({{static_cast<int>(b), static_cast<int>(k)}, bands[b]->corners(k)});
        CellBox box;
        for (const Point& p : cells_.back().corners) box.add(p);
        boxes_.push_back(box);
      }
    }
  }

  std::vector<std::array<CellId, 2>> run() {
    if (cells_.empty()) return {};
    around_.resize(4 * cells_.size());
    build(1, 0, cells_.size());
    within(1, 0, cells_.size());
    return std::move(found_);
  }

 private:
  const CellBox& build(std::size_t node, std::size_t lo, std::size_t hi) {
    if (hi - lo == 1) return around_[node] = boxes_[lo];
    const std::size_t middle = (lo + hi) / 2;
    CellBox box = build(2 * node, lo, middle);
    box.add(build(2 * node + 1, middle, hi));
    return around_[node] = box;
  }

  void within(std::size_t node, std::size_t lo, std::size_t hi) {
    if (hi - lo == 1) return;
    const std::size_t middle = (lo + hi) / 2;
    within(2 * node, lo, middle);
    within(2 * node + 1, middle, hi);
    across(2 * node, lo, middle, 2 * node + 1, middle, hi);
  }

  void across(std::size_t a, std::size_t a_lo, std::size_t a_hi, std::size_t b, std::size_t b_lo, std::size_t b_hi) {
    if (!around_[a].meets(around_[b])) return;
    if (a_hi - a_lo == 1 && b_hi - b_lo == 1) return look_at(cells_[a_lo], cells_[b_lo]);
    if (a_hi - a_lo >= b_hi - b_lo) {
      const std::size_t middle = (a_lo + a_hi) / 2;
      across(2 * a, a_lo, middle, b, b_lo, b_hi);
      across(2 * a + 1, middle, a_hi, b, b_lo, b_hi);
    } else {
      const std::size_t middle = (b_lo + b_hi) / 2;
      across(a, a_lo, a_hi, 2 * b, b_lo, middle);
      across(a, a_lo, a_hi, 2 * b + 1, middle, b_hi);
    }
  }

  void look_at(const PlacedCell& a, const PlacedCell& b) {
    interruption_point();
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
  std::vector<CellBox> boxes_, around_;
  std::vector<std::array<CellId, 2>> found_;
};

}  // namespace

std::vector<std::array<CellId, 2>> meeting_cells(const std::vector<const Band*>& bands) {
  return MeetingSearch(bands).run();
}

}  // namespace taut::curve
