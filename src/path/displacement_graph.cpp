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

/// A segment has one edge.
template <class Visit>
void for_each_edge(const ConvexRing& ring, const Visit& visit) {
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < (n == 2 ? 1 : n); ++k) {
    if (n > 1) visit(ring[k], ring[(k + 1) % n]);
  }
}

/// What is known of a point on the way.
struct Node {
  ExactPoint at;
  double length = INFINITY;  ///< of the shortest way to it that was found
  std::size_t before = 0;
  bool is_goal = false, is_done = false;
};

std::vector<ExactPoint> way_to(const std::vector<Node>& nodes, std::size_t last) {
  std::vector<ExactPoint> way = {nodes[last].at};
  for (std::size_t i = last; i != 0; i = nodes[i].before) way.push_back(nodes[nodes[i].before].at);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace

ConvexRing forbidden(const Polygon& rest, const Polygon& mover, const Dyadic& offset_x, const Dyadic& offset_y) {
  Polygon mirrored;
  for (const Point& p : mover) mirrored.push_back(minus(p));
  const std::size_t n = rest.size(), m = mirrored.size(), first = lowest(rest), second = lowest(mirrored);
  ConvexRing sum;
  for (std::size_t i = 0, k = 0; i < n || k < m;) {
    const Point &a = rest[(first + i) % n], &b = rest[(first + i + 1) % n];
    const Point &c = mirrored[(second + k) % m], &d = mirrored[(second + k + 1) % m];
    sum.push_back(ExactPoint::of(Dyadic::exact(a.x) + Dyadic::exact(c.x) + offset_x,
                                 Dyadic::exact(a.y) + Dyadic::exact(c.y) + offset_y));
    const int turn = i == n ? -1 : k == m ? 1 : cross_sign(a, b, c, d);
    if (turn >= 0) ++i;
    if (turn <= 0) ++k;
  }
  return sum;
}

double distance(const ExactPoint& a, const ExactPoint& b) {
  return std::hypot(b.near.x - a.near.x, b.near.y - a.near.y);
}

std::optional<ConvexRing> enlarged_by(const ConvexRing& ring, const Dyadic& share) {
  const ExactPoint middle = rounded_middle(ring);
  if (!is_inside(ring, middle)) return std::nullopt;
  ConvexRing larger;
  for (const ExactPoint& p : ring)
    larger.push_back(ExactPoint::of(p.x + share * (p.x - p.w * middle.x), p.y + share * (p.y - p.w * middle.y), p.w));
  return larger;
}

bool DisplacementGoal::contains(const ExactPoint& p) const {
  return path::contains(region, p) &&
         std::none_of(excluded.begin(), excluded.end(), [&](const ConvexRing& ring) { return is_inside(ring, p); });
}

DisplacementGraph::DisplacementGraph(std::vector<ConvexRing> obstacles, ConvexRing range)
    : obstacles_(std::move(obstacles)), range_(std::move(range)) {
  for (const ConvexRing& obstacle : obstacles_) boxes_.push_back(bounds_of(obstacle));
  const AxisBox around = bounds_of(range_);
  for (const ConvexRing& obstacle : obstacles_) {
    checkpoint();
    for (const ExactPoint& p : obstacle) {
      if (around.meets(bounds_of(p, p)) && contains(range_, p) && is_free(p)) corners_.push_back(p);
    }
  }
}

bool DisplacementGraph::is_free(const ExactPoint& p) const {
  const AxisBox at = bounds_of(p, p);
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    if (boxes_[i].meets(at) && is_inside(obstacles_[i], p)) return false;
  }
  return true;
}

/// The segment does not meet the inside of a convex polygon if and only if one of the polygon's edges, or the segment
/// itself, has them on two sides.
bool DisplacementGraph::passes(const ExactPoint& a, const ExactPoint& b) const {
  if (same(a, b)) return true;
  const AxisBox around = bounds_of(a, b);
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    if (!boxes_[i].meets(around)) continue;
    checkpoint();
    const ConvexRing& ring = obstacles_[i];
    bool left = false, right = false, separated = false;
    for (const ExactPoint& p : ring) {
      const int side = turn_sign(a, b, p);
      left = left || side > 0;
      right = right || side < 0;
    }
    separated = !left || !right;
    for (std::size_t k = 0; k < ring.size() && !separated; ++k) {
      const ExactPoint &c = ring[k], &d = ring[(k + 1) % ring.size()];
      separated = turn_sign(c, d, a) <= 0 && turn_sign(c, d, b) <= 0;
    }
    if (!separated) return false;
  }
  return true;
}

bool DisplacementGraph::is_entry(const ExactPoint& p, const DisplacementGoal& goal) const {
  return contains(range_, p) && goal.contains(p) && is_free(p);
}

/// A way that reaches the goal does so on one of the edges, and can go along it to where what is free of the edge ends:
/// there a corner is, or another edge crosses it.
std::vector<ExactPoint> DisplacementGraph::entries(const DisplacementGoal& goal, const std::vector<Edge>& edges) const {
  std::vector<ExactPoint> found;
  const auto add = [&](const ExactPoint& p) {
    if (is_entry(p, goal)) found.push_back(p);
  };
  for (const ExactPoint& p : goal.region) add(p);
  for (const Edge& edge : edges) {
    add(edge[0]);
    add(edge[1]);
    const AxisBox around = bounds_of(edge[0], edge[1]);
    const auto add_meeting = [&](const ExactPoint& a, const ExactPoint& b) {
      checkpoint();
      if (!around.meets(bounds_of(a, b))) return;
      if (const auto meeting = meeting_point(edge[0], edge[1], a, b)) add(*meeting);
    };
    for (const Edge& other : edges) add_meeting(other[0], other[1]);
    for_each_edge(range_, add_meeting);
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      if (boxes_[i].meets(around)) for_each_edge(obstacles_[i], add_meeting);
    }
  }
  return found;
}

/// Dijkstra's algorithm; which corners are seen from one is asked when it is reached. From each, the points of the
/// goal's edges that are straight across are goals as well.
std::optional<std::vector<ExactPoint>> DisplacementGraph::way(const ExactPoint& from,
                                                              const DisplacementGoal& goal) const {
  if (!is_free(from)) return std::nullopt;
  if (goal.contains(from)) return std::vector<ExactPoint>{from};
  std::vector<Edge> edges;
  const auto add_edge = [&](const ExactPoint& a, const ExactPoint& b) { edges.push_back({a, b}); };
  // With excluded polygons, the region is the range, and a way reaches the goal where it leaves the last of them.
  if (goal.excluded.empty()) for_each_edge(goal.region, add_edge);
  for (const ConvexRing& ring : goal.excluded) for_each_edge(ring, add_edge);
  std::vector<Node> nodes = {{from, 0}};
  for (const ExactPoint& corner : corners_) nodes.push_back({corner});
  for (ExactPoint& entry : entries(goal, edges)) {
    nodes.push_back({std::move(entry)});
    nodes.back().is_goal = true;
  }
  for (;;) {
    std::size_t next = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].is_done && nodes[i].length < INFINITY &&
          (next == nodes.size() || nodes[i].length < nodes[next].length))
        next = i;
    }
    if (next == nodes.size()) return std::nullopt;
    nodes[next].is_done = true;
    if (nodes[next].is_goal) return way_to(nodes, next);
    const ExactPoint at = nodes[next].at;
    const double length = nodes[next].length;
    for (Node& node : nodes) {
      const double d = length + distance(at, node.at);
      if (node.is_done || d >= node.length || !passes(at, node.at)) continue;
      node.length = d;
      node.before = next;
    }
    for (const Edge& edge : edges) {
      std::optional<ExactPoint> foot = foot_point(at, edge[0], edge[1]);
      if (!foot || !is_entry(*foot, goal) || !passes(at, *foot)) continue;
      const double d = length + distance(at, *foot);
      nodes.push_back({std::move(*foot), d, next, true});
    }
  }
}

}  // namespace taut::internal::path
