#include "scene/crossing_edges.hpp"

#include <algorithm>
#include <vector>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// An edge's rectangle, with room for the error of its ends' positions.
struct Extent {
  VertexId edge;
  double left, right, low, high;
};

bool cross(const Placement& place, VertexId e, VertexId f) {
  const PairGeometry& g = place.geometry();
  const VertexId e2 = g.next(e), f2 = g.next(f);
  return place.orientation(e, e2, f) != place.orientation(e, e2, f2) &&
         place.orientation(f, f2, e) != place.orientation(f, f2, e2);
}

std::vector<Extent> sorted_edges(const Placement& place) {
  const double room = place.position_error();
  std::vector<Extent> edges;
  for (std::uint32_t i = 0; i < place.size(); ++i) {
    const VertexId v(i);
    const Point a = place.approximate(v), b = place.approximate(place.geometry().next(v));
    edges.push_back({v, std::min(a.x, b.x) - room, std::max(a.x, b.x) + room, std::min(a.y, b.y) - room,
                     std::max(a.y, b.y) + room});
  }
  std::sort(edges.begin(), edges.end(), [](const Extent& a, const Extent& b) {
    return a.left != b.left ? a.left < b.left : a.edge.value < b.edge.value;
  });
  return edges;
}

}  // namespace

std::optional<EdgePair> crossing_edges(const Placement& place) {
  const PairGeometry& g = place.geometry();
  std::vector<Extent> open[2];  // of P and of Q: those that the sweep line may still meet
  for (const Extent& e : sorted_edges(place)) {
    const bool of_p = g.in_p(e.edge);
    std::vector<Extent>& others = open[of_p ? 1 : 0];
    others.erase(std::remove_if(others.begin(), others.end(), [&](const Extent& f) { return f.right < e.left; }),
                 others.end());
    for (const Extent& f : others) {
      checkpoint();
      if (e.low > f.high || f.low > e.high || !cross(place, e.edge, f.edge)) continue;
      return of_p ? EdgePair{e.edge, f.edge} : EdgePair{f.edge, e.edge};
    }
    open[of_p ? 0 : 1].push_back(e);
  }
  return std::nullopt;
}

}  // namespace taut::internal
