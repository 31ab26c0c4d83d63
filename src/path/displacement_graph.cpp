#include "path/displacement_graph.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "numeric/budget.hpp"

namespace taut::internal::path {
namespace {

Point minus(const Point& p) { return {-p.x, -p.y}; }

/// The lowest vertex, of these the leftmost one.
std::size_t lowest(const Polygon& ring) {
  const auto below = [](const Point& a, const Point& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); };
  return static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), below) - ring.begin());
}

/// The middle of the vertices, if it is strictly inside.
std::optional<ExactPoint> middle_of(const Obstacle& ring) {
  double x = 0, y = 0;
  for (const ExactPoint& p : ring) {
    x += p.near.x / static_cast<double>(ring.size());
    y += p.near.y / static_cast<double>(ring.size());
  }
  const ExactPoint middle = ExactPoint::of(Dyadic::exact(x), Dyadic::exact(y));
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const ExactPoint &a = ring[k], &b = ring[(k + 1) % ring.size()];
    if (a.x == b.x && a.y == b.y) continue;
    if (orientation(a, b, middle) <= 0) return std::nullopt;
    inside = true;
  }
  if (!inside) return std::nullopt;
  return middle;
}

AxisBox box_of(const Obstacle& ring) {
  AxisBox box;
  for (const ExactPoint& p : ring) box.include(p.near);
  return box;
}

/// More than points are rounded by.
AxisBox enlarged(const AxisBox& box) {
  const double margin =
      0x1p-48 * std::max({std::fabs(box.lo_x), std::fabs(box.lo_y), std::fabs(box.hi_x), std::fabs(box.hi_y)});
  return {box.lo_x - margin, box.lo_y - margin, box.hi_x + margin, box.hi_y + margin};
}

}  // namespace

int orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const double left = (b.near.x - a.near.x) * (c.near.y - a.near.y),
               right = (b.near.y - a.near.y) * (c.near.x - a.near.x);
  // Each rounded coordinate is off by 2^-53 of its size at the most, and so are the operations.
  const double size = std::max({std::fabs(a.near.x), std::fabs(a.near.y), std::fabs(b.near.x), std::fabs(b.near.y),
                                std::fabs(c.near.x), std::fabs(c.near.y)});
  if (std::fabs(left - right) > 0x1p-46 * size * size) return left > right ? 1 : -1;
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
}

Obstacle forbidden(const Polygon& rest, const Polygon& mover, const Dyadic& offset_x, const Dyadic& offset_y,
                   const Dyadic& growth) {
  Polygon mirrored;
  for (const Point& p : mover) mirrored.push_back(minus(p));
  const std::size_t n = rest.size(), m = mirrored.size(), first = lowest(rest), second = lowest(mirrored);
  Obstacle sum;
  for (std::size_t i = 0, k = 0; i < n || k < m;) {
    const Point &a = rest[(first + i) % n], &b = rest[(first + i + 1) % n];
    const Point &c = mirrored[(second + k) % m], &d = mirrored[(second + k + 1) % m];
    sum.push_back(ExactPoint::of(Dyadic::exact(a.x) + Dyadic::exact(c.x) + offset_x,
                                 Dyadic::exact(a.y) + Dyadic::exact(c.y) + offset_y));
    const int turn = i == n ? -1 : k == m ? 1 : cross_sign(a, b, c, d);
    if (turn >= 0) ++i;
    if (turn <= 0) ++k;
  }
  if (growth.is_zero()) return sum;
  const std::optional<ExactPoint> middle = middle_of(sum);
  if (!middle) return {};
  for (ExactPoint& p : sum) p = ExactPoint::of(p.x + growth * (p.x - middle->x), p.y + growth * (p.y - middle->y));
  return sum;
}

DisplacementGraph::DisplacementGraph(std::vector<Obstacle> obstacles, const AxisBox& range)
    : obstacles_(std::move(obstacles)) {
  for (const Obstacle& obstacle : obstacles_) boxes_.push_back(enlarged(box_of(obstacle)));
  const Dyadic lo_x = Dyadic::exact(range.lo_x), lo_y = Dyadic::exact(range.lo_y), hi_x = Dyadic::exact(range.hi_x),
               hi_y = Dyadic::exact(range.hi_y);
  const AxisBox roughly = enlarged(range);
  for (const Obstacle& obstacle : obstacles_) {
    checkpoint();
    for (const ExactPoint& p : obstacle) {
      if (!roughly.meets(AxisBox(p.near, p.near))) continue;
      if ((p.x - lo_x).sign() < 0 || (hi_x - p.x).sign() < 0 || (p.y - lo_y).sign() < 0 || (hi_y - p.y).sign() < 0)
        continue;
      if (is_free(p)) corners_.push_back(p);
    }
  }
}

bool DisplacementGraph::is_free(const ExactPoint& p) const {
  const AxisBox at = enlarged(AxisBox(p.near, p.near));
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    if (!boxes_[i].meets(at)) continue;
    const Obstacle& ring = obstacles_[i];
    bool inside = true;
    for (std::size_t k = 0; k < ring.size() && inside; ++k)
      inside = orientation(ring[k], ring[(k + 1) % ring.size()], p) > 0;
    if (inside) return false;
  }
  return true;
}

/// The segment does not meet the inside of a convex polygon if and only if one of the polygon's edges, or the segment
/// itself, has them on two sides.
bool DisplacementGraph::passes(const ExactPoint& a, const ExactPoint& b) const {
  const AxisBox around = enlarged(AxisBox(a.near, b.near));
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    if (!boxes_[i].meets(around)) continue;
    checkpoint();
    const Obstacle& ring = obstacles_[i];
    bool left = false, right = false, separated = false;
    for (const ExactPoint& p : ring) {
      const int side = orientation(a, b, p);
      left = left || side > 0;
      right = right || side < 0;
    }
    separated = !left || !right;
    for (std::size_t k = 0; k < ring.size() && !separated; ++k) {
      const ExactPoint &c = ring[k], &d = ring[(k + 1) % ring.size()];
      separated = orientation(c, d, a) <= 0 && orientation(c, d, b) <= 0;
    }
    if (!separated) return false;
  }
  return true;
}

/// Dijkstra's algorithm; which corners are seen from one is asked when it is reached.
std::optional<std::vector<ExactPoint>> DisplacementGraph::way(const ExactPoint& from,
                                                              const std::vector<ExactPoint>& goals) const {
  std::vector<const ExactPoint*> nodes = {&from};
  for (const ExactPoint& corner : corners_) nodes.push_back(&corner);
  const std::size_t first_goal = nodes.size();
  for (const ExactPoint& goal : goals) {
    if (is_free(goal)) nodes.push_back(&goal);
  }
  if (!is_free(from)) return std::nullopt;
  std::vector<double> length(nodes.size(), INFINITY);
  std::vector<std::size_t> before(nodes.size(), 0);
  std::vector<bool> done(nodes.size(), false);
  length[0] = 0;
  for (;;) {
    std::size_t next = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!done[i] && length[i] < INFINITY && (next == nodes.size() || length[i] < length[next])) next = i;
    }
    if (next == nodes.size()) return std::nullopt;
    done[next] = true;
    if (next >= first_goal) {
      std::vector<ExactPoint> way;
      for (std::size_t i = next;; i = before[i]) {
        way.insert(way.begin(), *nodes[i]);
        if (i == 0) return way;
      }
    }
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      if (done[i]) continue;
      const double d =
          length[next] + std::hypot(nodes[i]->near.x - nodes[next]->near.x, nodes[i]->near.y - nodes[next]->near.y);
      const bool same = nodes[i]->x == nodes[next]->x && nodes[i]->y == nodes[next]->y;
      if (d >= length[i] || !(same || passes(*nodes[next], *nodes[i]))) continue;
      length[i] = d;
      before[i] = next;
    }
  }
}

}  // namespace taut::internal::path
