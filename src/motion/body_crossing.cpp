#include "motion/body_crossing.hpp"

#include <algorithm>
#include <vector>

#include "numeric/interruption.hpp"

namespace taut {
namespace {

struct EdgeBounds {
  double left = 0, right = 0, low = 0, high = 0;

  /// Of an edge, with room for the displacement.
  static EdgeBounds of(const PairGeometry& g, VertexId e) {
    const DisplacedPoint &a = g.point(e), &b = g.point(g.next(e));
    constexpr double room = 0x1p-150;
    return {std::min(a.x, b.x) - room, std::max(a.x, b.x) + room, std::min(a.y, b.y) - room, std::max(a.y, b.y) + room};
  }
  static EdgeBounds both(const EdgeBounds& a, const EdgeBounds& b) {
    return {std::min(a.left, b.left), std::max(a.right, b.right), std::min(a.low, b.low), std::max(a.high, b.high)};
  }
  friend bool meet(const EdgeBounds& a, const EdgeBounds& b) {
    return a.left <= b.right && b.left <= a.right && a.low <= b.high && b.low <= a.high;
  }
};

bool edges_cross(const PairGeometry& g, VertexId a, VertexId b) {
  const VertexId a2 = g.next(a), b2 = g.next(b);
  if (a == b || a2 == b || b2 == a) return false;
  return g.rigid_orientation(a, a2, b) != g.rigid_orientation(a, a2, b2) &&
         g.rigid_orientation(b, b2, a) != g.rigid_orientation(b, b2, a2);
}

/// A tree of bounds over the edges of one polygon, joined with itself.
class SelfJoin {
 public:
  SelfJoin(const PairGeometry& g, std::uint32_t first, std::uint32_t count) : g_(g) {
    nodes_.reserve(2 * static_cast<std::size_t>(count));
    build(first, count);
  }

  std::optional<std::pair<VertexId, VertexId>> find() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
    while (!stack.empty()) {
      interruption_point();
      const auto [i, j] = stack.back();
      stack.pop_back();
      const Node &a = nodes_[i], &b = nodes_[j];
      if (!meet(a.bounds, b.bounds)) continue;
      if (i == j) {
        if (a.count > 1) stack.insert(stack.end(), {{a.left, a.left}, {a.left, a.right}, {a.right, a.right}});
      } else if (a.count == 1 && b.count == 1) {
        if (edges_cross(g_, VertexId(a.first), VertexId(b.first)))
          return std::pair(VertexId(a.first), VertexId(b.first));
      } else if (b.count == 1 || a.count > b.count) {
        stack.insert(stack.end(), {{a.left, j}, {a.right, j}});
      } else {
        stack.insert(stack.end(), {{i, b.left}, {i, b.right}});
      }
    }
    return std::nullopt;
  }

 private:
  struct Node {
    EdgeBounds bounds;
    std::uint32_t first, count, left = 0, right = 0;
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({EdgeBounds::of(g_, VertexId(first)), first, count});
    if (count == 1) return index;
    const std::uint32_t left = build(first, count / 2), right = build(first + count / 2, count - count / 2);
    nodes_[index].left = left;
    nodes_[index].right = right;
    nodes_[index].bounds = EdgeBounds::both(nodes_[left].bounds, nodes_[right].bounds);
    return index;
  }

  const PairGeometry& g_;
  std::vector<Node> nodes_;
};

}  // namespace

std::optional<std::pair<VertexId, VertexId>> crossing_within_body(const PairGeometry& g) {
  if (const auto found = SelfJoin(g, 0, g.np).find()) return found;
  return SelfJoin(g, g.np, g.nq).find();
}

}  // namespace taut
