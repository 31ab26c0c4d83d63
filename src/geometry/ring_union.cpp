#include "geometry/region_union.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/box_tree.hpp"
#include "geometry/predicates.hpp"
#include "numeric/budget.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/errors.hpp"
#include "numeric/exact_sum.hpp"

namespace taut::internal {
namespace {

/// Three edges meet in a point, or a vertex lies on an edge.
struct NotGeneral {};

/// Twice the area of a triangle, as an exact sum.
ExactSum<16> doubled_area(const Point& a, const Point& b, const Point& c) {
  ExactSum<16> sum;
  sum.add_product(a.x, b.y);
  sum.subtract_product(a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.subtract_product(b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.subtract_product(c.y, a.x);
  return sum;
}

Dyadic exact(const ExactSum<16>& sum) {
  Dyadic total;
  for (std::size_t i = 0; i < sum.size(); ++i) total = total + Dyadic::exact(sum.term(i));
  return total;
}

/// Where an edge is crossed by another one: at the share from / (from + to) of its length.
struct Crossing {
  std::uint32_t other = 0;  ///< the other edge
  int change = 0;           ///< of the winding number along the edge: +1 towards the other edge's left
  ExactSum<16> from, to;    ///< how far the edge's ends are from the other edge's line; both positive

  double share() const {
    const double a = from.approximate(), b = to.approximate();
    return a / (a + b);
  }
};

/// Is the first crossing of an edge nearer to its beginning?
bool comes_before(const Crossing& c, const Crossing& d) {
  constexpr double rounding = 0x1p-48;
  const double difference = c.share() - d.share();
  if (std::fabs(difference) > rounding) return difference < 0;
  const int sign = (exact(c.from) * exact(d.to) - exact(d.from) * exact(c.to)).sign();
  if (sign == 0 && c.other != d.other) throw NotGeneral{};
  return sign < 0;
}

class UnionBuilder {
 public:
  explicit UnionBuilder(const std::vector<Polygon>& rings) {
    for (std::uint32_t r = 0; r < rings.size(); ++r) {
      const auto first = static_cast<std::uint32_t>(edges_.size()), n = static_cast<std::uint32_t>(rings[r].size());
      first_.push_back(first);
      for (std::uint32_t k = 0; k < n; ++k)
        edges_.push_back({rings[r][k], rings[r][(k + 1) % n], r, first + (k + 1) % n, first + (k + n - 1) % n, {}, {}});
    }
  }

  RingUnion run() {
    find_crossings();
    for (const std::uint32_t first : first_) wind(first);
    RingUnion result;
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      for (std::size_t k = 0; k < edges_[e].left.size(); ++k) {
        if (edges_[e].left[k] == 1) result.rings.push_back(trace(e, k));
        // What is inside of another ring, or outside of its own, is no boundary.
        result.changed = result.changed || edges_[e].left[k] != traced;
      }
    }
    return result;
  }

 private:
  struct Edge {
    Point a, b;
    std::uint32_t ring = 0, next = 0, previous = 0;
    std::vector<Crossing> crossings;  ///< along the edge
    std::vector<int> left;            ///< the winding number to the left before each crossing, and after the last one
  };
  /// In place of the winding number of what was traced.
  static constexpr int traced = -1000000000;

  void find_crossings() {
    std::vector<AxisBox> boxes;
    for (const Edge& e : edges_) boxes.emplace_back(e.a, e.b);
    BoxTree(boxes).each_two([&](int i, int k) {
      checkpoint();
      note_crossing(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
    });
    for (Edge& e : edges_) std::sort(e.crossings.begin(), e.crossings.end(), comes_before);
  }

  void note_crossing(std::uint32_t i, std::uint32_t k) {
    Edge &e = edges_[i], &f = edges_[k];
    if (e.next == k || f.next == i) return;
    const int f_a = orientation(e.a, e.b, f.a), f_b = orientation(e.a, e.b, f.b);
    const int e_a = orientation(f.a, f.b, e.a), e_b = orientation(f.a, f.b, e.b);
    if (f_a * f_b > 0 || e_a * e_b > 0) return;
    if (f_a * f_b == 0 || e_a * e_b == 0) throw NotGeneral{};
    e.crossings.push_back(crossing(f, k, e.a, e.b, e_b));
    f.crossings.push_back(crossing(e, i, f.a, f.b, f_b));
  }

  static Crossing crossing(const Edge& other, std::uint32_t number, const Point& a, const Point& b, int side_of_b) {
    Crossing c;
    c.other = number;
    c.change = side_of_b;
    const auto distance = [&](const Point& p, int side) {
      return side > 0 ? doubled_area(other.a, other.b, p) : doubled_area(other.b, other.a, p);
    };
    c.from = distance(a, -side_of_b);
    c.to = distance(b, side_of_b);
    return c;
  }

  /// How often all rings wind around a point just to the left of their ring's leftmost vertex.
  int winding_beside(const Point& p) const {
    int winds = 0;
    for (const Edge& e : edges_) {
      if ((e.a.y <= p.y) == (e.b.y <= p.y) || e.a == p || e.b == p) continue;
      const int side = orientation(e.a, e.b, p);
      if (side == 0) throw NotGeneral{};
      const bool down = e.b.y <= p.y;
      if (down == (side > 0)) winds += side;
    }
    return winds;
  }

  /// Winding numbers along a ring, from its leftmost vertex on.
  void wind(std::uint32_t first) {
    checkpoint();
    std::uint32_t start = first;
    for (std::uint32_t e = edges_[first].next; e != first; e = edges_[e].next) {
      if (lexicographically_less(edges_[e].a, edges_[start].a)) start = e;
    }
    const Edge& leftmost = edges_[start];
    const int turn = orientation(edges_[leftmost.previous].a, leftmost.a, leftmost.b);
    if (turn == 0) throw NotGeneral{};
    const int begin = winding_beside(leftmost.a) + (turn > 0 ? 1 : 0);
    int left = begin;
    std::uint32_t e = start;
    do {
      edges_[e].left.push_back(left);
      for (const Crossing& c : edges_[e].crossings) edges_[e].left.push_back(left += c.change);
      e = edges_[e].next;
    } while (e != start);
    if (left != begin) throw StructureError("winding numbers that do not add up");
  }

  /// At a crossing the boundary goes over to the other edge: only one of the two goes on next to the outside.
  std::vector<UnionVertex> trace(std::uint32_t e, std::size_t k) {
    std::vector<UnionVertex> ring;
    for (; edges_[e].left[k] != traced;) {
      if (edges_[e].left[k] != 1) throw StructureError("a boundary that does not go on");
      edges_[e].left[k] = traced;
      const Edge& edge = edges_[e];
      if (k == edge.crossings.size()) {
        e = edge.next;
        k = 0;
        ring.push_back({edge.b, edges_[e].ring, e - first_[edges_[e].ring]});
        continue;
      }
      const double share = edge.crossings[k].share();
      const Point at{edge.a.x + share * (edge.b.x - edge.a.x), edge.a.y + share * (edge.b.y - edge.a.y)};
      const std::uint32_t other = edge.crossings[k].other;
      const std::vector<Crossing>& there = edges_[other].crossings;
      const auto same = std::find_if(there.begin(), there.end(), [&](const Crossing& c) { return c.other == e; });
      k = static_cast<std::size_t>(same - there.begin()) + 1;
      e = other;
      ring.push_back({at, edges_[e].ring, e - first_[edges_[e].ring]});
    }
    return ring;
  }

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> first_;  ///< edge of each ring
};

}  // namespace

std::optional<RingUnion> union_of(const std::vector<Polygon>& rings) {
  try {
    return UnionBuilder(rings).run();
  } catch (const NotGeneral&) {
    return std::nullopt;
  }
}

}  // namespace taut::internal
