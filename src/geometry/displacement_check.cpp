// Why the laws of displaced_polygon() hold, and their check where that argument does not reach.
//
// Let R be the ring, R' the displaced one, and D more than the way of any vertex. Each point of R' is at most D from
// the point of R with the same place on the same edge. By the law of corners (displace()), both ends of an edge e' lie
// between delta and 2 delta to the inner side of e's line, and so does all of e': this is the third law, and e' does
// not meet e.
//
// Let two edges be called clear of each other if they are no neighbours and their distance is more than 2 D, or if they
// are uv and vw, w is farther than 2 D from the line of uv, or on it beyond v, and u is from the line of vw, likewise.
// * Of edges e, g that are no neighbours and clear, e' meets neither g' nor g, nor e g'. Of neighbours that are clear,
//   e', g' share a vertex and nothing else: the far end of g' stays off e'.
// * Of these, vw does not meet the displaced edge before it, from u' to v': where the corner v is convex, w is on the
//   inner side of the line of uv, and v' strictly on the inner side of vw's line, u' also, as it moves by less than its
//   distance. Where v is reflex, vw lies on the outer side of the line of uv, or on it, and u'v' strictly on the inner
//   side. uv and v'w' likewise.
//
// If all pairs of edges are clear of each other:
// * R' is simple, and so are all rings on the straight way from R to R': none of them turns inside out.
// * R' does not meet R. Hence it lies wholly on one side of R, and at v that is the inner side, where v' is.
// Moving outwards is the same with the sides exchanged.
//
// Where coordinates are coarse that is seen at once: has_room(). Else edges whose boxes, with room on all sides, do not
// meet are clear, and of the others doubles show nearly all to be: a point that is certainly on one side of a line is
// far from it (orientation_in_doubles()). Those that are not shown to be clear are tested exactly, one by one, and
// then so is the side on which R' lies.
#include "geometry/displacement.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/axis_box.hpp"
#include "numeric/budget.hpp"
#include "numeric/exact_sum.hpp"

namespace taut::internal {
namespace {

using Ring = std::vector<DisplacedPoint>;

DisplacedPoint before_displacement(const DisplacedPoint& v) { return {v.x, v.y, 0, 0}; }

/// The sign of a coordinate's difference, displacement included.
int compare(double a, double da, double b, double db) {
  ExactSum<4> sum;
  for (const double x : {da, -db, a, -b}) sum.add(x);
  return sum.sign();
}

/// A tree of bounds over the edges of the ring, joined with itself.
class RingCheck {
 public:
  /// No vertex moves by more than `room`.
  RingCheck(const Ring& ring, double room) : ring_(ring), n_(static_cast<std::uint32_t>(ring.size())), room_(room) {
    nodes_.reserve(2 * ring.size());
    build(0, n_);
  }

  /// Edges by which the displaced ring meets itself or the one it was made of.
  std::optional<DisplacementFault> close_edges() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
    while (!stack.empty()) {
      checkpoint();
      const auto [i, j] = stack.back();
      stack.pop_back();
      const Node &a = nodes_[i], &b = nodes_[j];
      if (!a.bounds.meets(b.bounds)) continue;
      if (i == j) {
        if (a.count > 1) stack.insert(stack.end(), {{a.left, a.left}, {a.left, a.right}, {a.right, a.right}});
      } else if (a.count == 1 && b.count == 1) {
        if (clear(a.first, b.first)) continue;
        all_clear_ = false;
        if (edges_meet(a.first, b.first))
          return DisplacementFault{DisplacementFault::Kind::close_edges, a.first, b.first};
      } else if (b.count == 1 || a.count > b.count) {
        stack.insert(stack.end(), {{a.left, j}, {a.right, j}});
      } else {
        stack.insert(stack.end(), {{i, b.left}, {i, b.right}});
      }
    }
    return std::nullopt;
  }
  /// No edges had to be tested exactly.
  bool all_clear() const { return all_clear_; }

 private:
  struct Node {
    AxisBox bounds;  ///< of edges before and after the displacement
    std::uint32_t first, count, left = 0, right = 0;
  };

  std::uint32_t next(std::uint32_t v) const { return v + 1 == n_ ? 0 : v + 1; }

  int side(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c) const {
    return orientation(a, b, c, room_);
  }
  /// If c is certainly far from the line.
  int far_side(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c) const {
    return orientation_in_doubles(a, b, c, room_);
  }
  /// May the segments ab and cd have a point in common? Certainly not if this is false.
  bool may_meet(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                const DisplacedPoint& d) const {
    const auto apart = [](int s, int t) { return s == t && s != 0; };
    return !apart(side(a, b, c), side(a, b, d)) && !apart(side(c, d, a), side(c, d, b));
  }
  /// Are c and d certainly far from the line ab, on one side of it?
  bool runs_along(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                  const DisplacedPoint& d) const {
    const int s = far_side(a, b, c);
    return s != 0 && far_side(a, b, d) == s;
  }
  /// Are two different edges certainly clear of each other?
  bool clear(std::uint32_t i, std::uint32_t j) const {
    const DisplacedPoint &a = ring_[i], &b = ring_[next(i)], &c = ring_[j], &d = ring_[next(j)];
    if (next(i) == j) return far_side(a, b, d) != 0 && far_side(c, d, a) != 0;
    if (next(j) == i) return far_side(c, d, b) != 0 && far_side(a, b, c) != 0;
    return runs_along(a, b, c, d) || runs_along(c, d, a, b);
  }
  /// Two different edges.
  bool edges_meet(std::uint32_t i, std::uint32_t j) const {
    const DisplacedPoint &a = ring_[i], &b = ring_[next(i)], &c = ring_[j], &d = ring_[next(j)];
    if (may_meet(a, b, before_displacement(c), before_displacement(d)) ||
        may_meet(before_displacement(a), before_displacement(b), c, d)) {
      return true;
    }
    // Neighbours meet in their common vertex, and nowhere else unless they lie on one line.
    if (next(i) == j) return side(a, b, d) == 0;
    if (next(j) == i) return side(c, d, b) == 0;
    return may_meet(a, b, c, d);
  }

  AxisBox edge_bounds(const DisplacedPoint& a, const DisplacedPoint& b) const {
    return AxisBox({a.x, a.y}, {b.x, b.y}, room_);
  }

  std::uint32_t build(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({edge_bounds(ring_[first], ring_[next(first)]), first, count});
    if (count == 1) return index;
    const std::uint32_t left = build(first, count / 2), right = build(first + count / 2, count - count / 2);
    nodes_[index].left = left;
    nodes_[index].right = right;
    nodes_[index].bounds = nodes_[left].bounds;
    nodes_[index].bounds.include(nodes_[right].bounds);
    return index;
  }

  const Ring& ring_;
  std::uint32_t n_;
  double room_;
  std::vector<Node> nodes_;
  bool all_clear_ = true;
};

/// The parity of the edges that a ray from v to the right crosses. v must not lie on the ring.
bool contains(const Ring& ring, const DisplacedPoint& v, double room) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const DisplacedPoint &a = ring[i], &b = ring[i + 1 == ring.size() ? 0 : i + 1];
    const bool a_above = compare(a.y, a.dy, v.y, v.dy) > 0, b_above = compare(b.y, b.dy, v.y, v.dy) > 0;
    if (a_above != b_above && (orientation(a, b, v, room) > 0) == b_above) inside = !inside;
  }
  return inside;
}

/// Of a simple ring: by its lowest vertex, of those the one farthest to the left.
bool is_counterclockwise(const Ring& ring, double room) {
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const DisplacedPoint &a = ring[i], &b = ring[lowest];
    const int y = compare(a.y, a.dy, b.y, b.dy);
    if (y < 0 || (y == 0 && compare(a.x, a.dx, b.x, b.dx) < 0)) lowest = i;
  }
  const std::size_t n = ring.size();
  return orientation(ring[(lowest + n - 1) % n], ring[lowest], ring[(lowest + 1) % n], room) > 0;
}

}  // namespace

bool has_room(const std::vector<Point>& polygon, double farthest) {
  // Where all coordinates are multiples of 2^-k, twice the area of a triangle is one of 2^-2k, and edges are shorter
  // than sqrt 8: so f is 2^(-2k - 1.5) at least. The largest k for which that is more than 2 D:
  const int k = (-(std::ilogb(farthest) + 1) - 3) / 2;
  const auto coarse = [k](double c) { return std::ldexp(std::floor(std::ldexp(c, k)), -k) == c; };
  return k > 0 &&
         std::all_of(polygon.begin(), polygon.end(), [&](const Point& v) { return coarse(v.x) && coarse(v.y); });
}

std::optional<DisplacementFault> find_displacement_fault(const std::vector<DisplacedPoint>& ring, Offset offset,
                                                         double farthest) {
  const double room = std::max(displacement_room, farthest);
  RingCheck check(ring, room);
  if (const auto fault = check.close_edges()) return fault;
  if (check.all_clear()) return std::nullopt;
  // The two rings are simple and do not meet: one vertex shows which lies inside.
  Ring original;
  original.reserve(ring.size());
  for (const DisplacedPoint& v : ring) original.push_back(before_displacement(v));
  const bool right_side =
      offset == Offset::inward ? contains(original, ring[0], room) : contains(ring, original[0], room);
  if (right_side && is_counterclockwise(ring, room)) return std::nullopt;
  return DisplacementFault{DisplacementFault::Kind::close_edges, static_cast<std::uint32_t>(ring.size() - 1), 0};
}

}  // namespace taut::internal
