// Do the bodies overlap in one placement? Boxes first, then exact signs.
#include <algorithm>
#include <utility>
#include <vector>

#include "motion/placement.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/first_contact.hpp"

namespace taut::spacetime {
namespace {

bool edges_cross(const Placement& place, VertexId a, VertexId b) {
  const PairGeometry& g = place.geometry();
  const VertexId a2 = g.next(a), b2 = g.next(b);
  return place.orientation(a, a2, b) != place.orientation(a, a2, b2) &&
         place.orientation(b, b2, a) != place.orientation(b, b2, a2);
}

/// Is a vertex of one body inside the other? A ray along the sweep's "up" crosses its boundary an odd number of times.
bool inside(const Placement& place, VertexId v, std::uint32_t first, std::uint32_t count) {
  const PairGeometry& g = place.geometry();
  bool odd = false;
  for (std::uint32_t k = 0; k < count; ++k) {
    const VertexId a(first + k), b = g.next(a);
    const bool forwards = place.before(a, v);
    if (forwards == place.before(b, v)) continue;
    if (place.orientation(forwards ? a : b, forwards ? b : a, v) < 0) odd = !odd;
  }
  return odd;
}

}  // namespace

std::optional<StartOverlap> overlapping(const PairGeometry& g, const Leg& leg, double t) {
  const Placement place(g, leg, t);
  const Hierarchy p(g, true), q(g, false);
  FrameWindow window(leg, t, leg.end, leg.end - t);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const BoxNode &a = p.node(i), &b = q.node(j);
    if (apart_at(leg, window, a.box, b.box, t)) continue;
    if (a.count == 1 && b.count == 1) {
      if (edges_cross(place, VertexId(a.first), VertexId(b.first))) {
        return StartOverlap{true, VertexId(a.first), VertexId(b.first)};
      }
    } else if (b.count == 1 || (a.count > 1 && a.box.size >= b.box.size)) {
      stack.insert(stack.end(), {{a.left, j}, {a.right, j}});
    } else {
      stack.insert(stack.end(), {{i, b.left}, {i, b.right}});
    }
  }
  if (inside(place, VertexId(0u), g.np, g.nq) || inside(place, VertexId(g.np), 0, g.np)) return StartOverlap{};
  return std::nullopt;
}

namespace {

/// Bounds of an edge, with room for the displacement.
struct EdgeBounds {
  VertexId edge;
  double left, right, low, high;

  EdgeBounds(const PairGeometry& g, VertexId e) : edge(e) {
    const DisplacedPoint &a = g.point(e), &b = g.point(g.next(e));
    constexpr double room = 0x1p-150;
    left = std::min(a.x, b.x) - room;
    right = std::max(a.x, b.x) + room;
    low = std::min(a.y, b.y) - room;
    high = std::max(a.y, b.y) + room;
  }
};

bool cross_within_body(const PairGeometry& g, VertexId a, VertexId b) {
  const VertexId a2 = g.next(a), b2 = g.next(b);
  if (a2 == b || b2 == a) return false;
  return g.rigid_orientation(a, a2, b) != g.rigid_orientation(a, a2, b2) &&
         g.rigid_orientation(b, b2, a) != g.rigid_orientation(b, b2, a2);
}

}  // namespace

std::optional<std::pair<VertexId, VertexId>> crossing_within_body(const PairGeometry& g) {
  std::vector<EdgeBounds> edges;
  for (std::uint32_t i = 0; i < g.size(); ++i) edges.emplace_back(g, VertexId(i));
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.left < b.left; });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const EdgeBounds& a = edges[i];
    for (std::size_t j = i + 1; j < edges.size() && edges[j].left <= a.right; ++j) {
      const EdgeBounds& b = edges[j];
      if (a.high < b.low || b.high < a.low || !g.same_body(a.edge, b.edge)) continue;
      if (cross_within_body(g, a.edge, b.edge)) return std::pair(a.edge, b.edge);
    }
  }
  return std::nullopt;
}

}  // namespace taut::spacetime
