#include "tiling/prepared_tiling.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "scene/placement.hpp"

namespace taut::internal {
namespace {

/// How many edges are tried, the longest first.
constexpr std::size_t edges_to_try = 4;

/// An edge of one hull, and how far beyond it the other one is, about.
struct HullEdge {
  VertexId from, to;
  double length, gap;
  bool of_p;
};

std::vector<Point> hull_positions(const Placement& placement, const std::vector<VertexId>& hull) {
  std::vector<Point> points;
  points.reserve(hull.size());
  for (const VertexId v : hull) points.push_back(placement.approximate(v));
  return points;
}

/// Edges turn to the left, one after the other, and so does the direction in which the other hull comes next to them:
/// its corner there goes around once (Shamos's calipers).
void add_hull_edges(const std::vector<VertexId>& hull, const std::vector<Point>& points,
                    const std::vector<Point>& other, bool of_p, std::vector<HullEdge>& edges) {
  std::size_t nearest = 0;
  const auto beyond = [&](std::size_t i, std::size_t j, const Point& direction) {
    return direction.y * (other[j].x - points[i].x) - direction.x * (other[j].y - points[i].y);
  };
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const std::size_t next = (i + 1) % hull.size();
    const Point direction{points[next].x - points[i].x, points[next].y - points[i].y};
    if (i == 0) {
      for (std::size_t j = 1; j < other.size(); ++j) {
        if (beyond(0, j, direction) < beyond(0, nearest, direction)) nearest = j;
      }
    }
    for (std::size_t steps = 0; steps < other.size(); ++steps) {
      const std::size_t j = (nearest + 1) % other.size();
      if (!(beyond(i, j, direction) < beyond(i, nearest, direction))) break;
      nearest = j;
    }
    const double length = std::hypot(direction.x, direction.y);
    if (length > 0) edges.push_back({hull[i], hull[next], length, beyond(i, nearest, direction) / length, of_p});
  }
}

}  // namespace

bool hulls_apart(const Placement& placement, const std::vector<VertexId>& hull_p, const std::vector<VertexId>& hull_q) {
  count_work((hull_p.size() + hull_q.size()) / 8);
  const std::vector<Point> p = hull_positions(placement, hull_p), q = hull_positions(placement, hull_q);
  std::vector<HullEdge> edges;
  edges.reserve(p.size() + q.size());
  add_hull_edges(hull_p, p, q, true, edges);
  add_hull_edges(hull_q, q, p, false, edges);
  double widest = -INFINITY;
  for (const HullEdge& e : edges) widest = std::max(widest, e.gap);
  const double close = 16 * placement.position_error();
  if (!(widest > -close)) return false;
  std::erase_if(edges, [&](const HullEdge& e) { return e.gap < widest - close; });
  std::stable_sort(edges.begin(), edges.end(),
                   [](const HullEdge& a, const HullEdge& b) { return a.length > b.length; });
  if (edges.size() > edges_to_try) edges.resize(edges_to_try);
  return std::any_of(edges.begin(), edges.end(), [&](const HullEdge& e) {
    const std::vector<VertexId>& other = e.of_p ? hull_q : hull_p;
    return std::all_of(other.begin(), other.end(),
                       [&](VertexId v) { return placement.orientation(e.from, e.to, v) < 0; });
  });
}

}  // namespace taut::internal
