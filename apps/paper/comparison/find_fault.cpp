// The checks of a tiling, from its definition.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "comparison/half_edges.hpp"
#include "geometry/predicates.hpp"

namespace taut::paper {
namespace {

class Check {
 public:
  Check(const HalfEdges& map, const MovingBodies& bodies, const std::vector<Point>& positions)
      : map_(map), bodies_(bodies), positions_(positions) {}

  std::string faces() {
    std::vector<bool> seen(static_cast<std::size_t>(map_.size()));
    int infinite = 0;
    for (int start = 0; start < map_.size(); ++start) {
      if (seen[static_cast<std::size_t>(start)]) continue;
      ++faces_;
      int convex = 0, length = 0, h = start;
      do {
        if (map_.origin(map_.next(h)) != map_.target(h))
          return fmt::format("half-edge {} does not end where the next begins", h);
        if (map_.is_inside(h) != map_.is_inside(start))
          return fmt::format("a face lies inside and outside of a body, at {}", h);
        seen[static_cast<std::size_t>(h)] = true;
        const int turn = turn_at(h);
        if (turn == 0) return fmt::format("a straight corner at vertex {}", map_.origin(h));
        convex += turn > 0;
        if (++length > map_.size()) return "a face without an end";
      } while ((h = map_.next(h)) != start);
      if (map_.is_inside(start)) continue;
      infinite += convex == 0;
      if (convex != 0 && convex != 3)
        return fmt::format("a face with {} convex corners at vertex {}", convex, map_.origin(start));
    }
    return infinite == 1 ? "" : fmt::format("{} infinite faces", infinite);
  }

  /// Once around a vertex, counterclockwise, the directions of its edges turn by 360 degrees.
  std::string order_around_vertices() const {
    std::vector<bool> seen(static_cast<std::size_t>(map_.size()));
    for (int start = 0; start < map_.size(); ++start) {
      if (seen[static_cast<std::size_t>(start)]) continue;
      int h = start, wraps = 0;
      do {
        seen[static_cast<std::size_t>(h)] = true;
        // The edge after this one, counterclockwise: back along the one that arrives on its left.
        wraps += before(map_.origin(h), map_.target(after_of(h)), map_.target(h));
      } while ((h = after_of(h)) != start);
      if (wraps != 1) return fmt::format("edges out of order around vertex {}", map_.origin(start));
    }
    return {};
  }

  std::string euler() const {
    const int edges = map_.size() / 2, vertices = bodies_.vertices();
    return vertices - edges + faces_ == 2 ? "" : fmt::format("Euler: {} - {} + {}", vertices, edges, faces_);
  }

  /// No two edges cross: all pairs, those apart along x left out.
  std::string crossings() const {
    std::vector<int> edges;
    for (int h = 0; h < map_.size(); h += 2) edges.push_back(h);
    const auto left = [&](int h) { return std::min(at(map_.origin(h)).x, at(map_.target(h)).x); };
    const auto right = [&](int h) { return std::max(at(map_.origin(h)).x, at(map_.target(h)).x); };
    std::sort(edges.begin(), edges.end(), [&](int a, int b) { return left(a) < left(b); });
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (std::size_t j = i + 1; j < edges.size() && left(edges[j]) <= right(edges[i]); ++j) {
        if (cross(edges[i], edges[j])) return fmt::format("edges {} and {} cross", edges[i], edges[j]);
      }
    }
    return {};
  }

 private:
  const Point& at(int vertex) const { return positions_[static_cast<std::size_t>(vertex)]; }
  int after_of(int h) const { return HalfEdges::twin(map_.previous(h)); }
  int turn_at(int h) const {
    return internal::orientation(at(map_.origin(map_.previous(h))), at(map_.origin(h)), at(map_.target(h)));
  }
  /// Whether the direction from v to a comes before that to b, in [0, 360) degrees.
  bool before(int v, int a, int b) const {
    const auto upper = [&](int w) { return at(w).y > at(v).y || (at(w).y == at(v).y && at(w).x > at(v).x); };
    if (upper(a) != upper(b)) return upper(a);
    return internal::orientation(at(v), at(a), at(b)) > 0;
  }
  bool cross(int g, int h) const {
    const int a = map_.origin(g), b = map_.target(g), c = map_.origin(h), d = map_.target(h);
    if (a == c || a == d || b == c || b == d) return false;
    const auto side = [&](int u, int v, int w) { return internal::orientation(at(u), at(v), at(w)); };
    return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
  }

  const HalfEdges& map_;
  const MovingBodies& bodies_;
  const std::vector<Point>& positions_;
  int faces_ = 0;
};

}  // namespace

std::string find_fault(const HalfEdges& map, const MovingBodies& bodies, const std::vector<Point>& positions,
                       bool crossings) {
  Check check(map, bodies, positions);
  std::string fault = check.faces();
  if (fault.empty()) fault = check.order_around_vertices();
  if (fault.empty()) fault = check.euler();
  if (fault.empty() && crossings) fault = check.crossings();
  return fault;
}

}  // namespace taut::paper
