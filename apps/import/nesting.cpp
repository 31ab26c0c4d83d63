#include "import/nesting.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"

namespace taut::drawing {

namespace {

struct Box {
  double lo_x, lo_y, hi_x, hi_y;
  explicit Box(const Polygon& ring) : lo_x(ring[0].x), lo_y(ring[0].y), hi_x(ring[0].x), hi_y(ring[0].y) {
    for (const Point& p : ring) {
      lo_x = std::min(lo_x, p.x);
      lo_y = std::min(lo_y, p.y);
      hi_x = std::max(hi_x, p.x);
      hi_y = std::max(hi_y, p.y);
    }
  }
  bool holds(const Box& o) const { return lo_x <= o.lo_x && lo_y <= o.lo_y && hi_x >= o.hi_x && hi_y >= o.hi_y; }
};

double doubled_area(const Polygon& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += (a.x - ring[0].x) * (b.y - ring[0].y) - (a.y - ring[0].y) * (b.x - ring[0].x);
  }
  return sum;
}

/// By the first of the inner ring's vertices that is not on the outer one.
bool lies_in(const Polygon& inner, const Polygon& outer) {
  for (const Point& p : inner) {
    const int side = side_of_ring(outer, p);
    if (side != 0) return side > 0;
  }
  return false;
}

/// The ring right around each ring, or -1; `order` has larger rings first.
std::vector<int> parents_of(const std::vector<Chain>& rings, const std::vector<std::size_t>& order) {
  std::vector<int> parents(rings.size(), -1);
  std::vector<Box> boxes;
  for (const Chain& ring : rings) boxes.emplace_back(ring.points);
  for (std::size_t k = 0; k < order.size(); ++k) {
    // The smallest of the larger ones that it lies in.
    for (std::size_t j = k; j-- > 0;) {
      if (!boxes[order[j]].holds(boxes[order[k]]) || !lies_in(rings[order[k]].points, rings[order[j]].points)) continue;
      parents[order[k]] = static_cast<int>(order[j]);
      break;
    }
  }
  return parents;
}

}  // namespace

bool tidy_ring(std::vector<Point>& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  for (std::size_t i = 2; i < ring.size(); ++i)
    if (orientation(ring[0], ring[1], ring[i]) != 0) return true;
  return false;
}

std::vector<NestedPart> nest(const std::vector<Chain>& rings, Fill fill, int& idle) {
  std::vector<double> areas;
  std::vector<std::size_t> order;
  for (const Chain& ring : rings) {
    order.push_back(areas.size());
    areas.push_back(doubled_area(ring.points));
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return std::fabs(areas[a]) > std::fabs(areas[b]); });
  const std::vector<int> parents = parents_of(rings, order);
  // How often the boundary goes round what is inside each ring, and the part whose material is there.
  std::vector<int> winding(rings.size(), 0), part_of(rings.size(), -1);
  std::vector<NestedPart> parts;
  const auto filled = [fill](int w) { return fill == Fill::nonzero ? w != 0 : w % 2 != 0; };
  for (const std::size_t k : order) {
    const int parent = parents[k];
    const int outside = parent < 0 ? 0 : winding[static_cast<std::size_t>(parent)];
    const int around = parent < 0 ? -1 : part_of[static_cast<std::size_t>(parent)];
    winding[k] = outside + (areas[k] > 0 ? 1 : -1);
    if (filled(outside) == filled(winding[k])) {
      ++idle;
      part_of[k] = around;
    } else if (filled(outside)) {
      parts[static_cast<std::size_t>(around)].part.holes.push_back(rings[k].points);
    } else {
      part_of[k] = static_cast<int>(parts.size());
      parts.push_back({{rings[k].points, {}}, rings[k].place});
    }
  }
  return parts;
}

}  // namespace taut::drawing
