#include "tiling/root_faces.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "scene/placement.hpp"

namespace taut::internal {
namespace {

/// The two chains bound a solid body, both hulls together. They curve away from the free space, A to the left and B to
/// the right, so that among the free space's corners only z_a and z_b are convex. Wanted is an edge through free space
/// that A passes on its right at its first vertex y, and that at its other end either has B on its right, or is z_a, or
/// has A on its left; z_b is then in the part that it cuts off, a pseudo-triangle, and the infinite face keeps one
/// convex corner.
///
/// There is only one such edge. From a vertex of A on the convex hull of both bodies (P has the larger diameter, so
/// there is one; z_a and z_b are none), backwards along A to y, over the edge, and along its chain on to z_a: this path
/// bends only around what it touches. Free space cut open from that vertex to infinity is simply connected, and has one
/// such path from there to z_a. (The edge cannot begin beyond that vertex, nor, if it ends on A, end before it: one
/// side of it would be a bounded polygon with a single convex corner.)
///
/// Two walks search for it, each a line that sweeps over triangles of a pseudo-triangle which the wanted edge closes.
/// Of a polygon's ears two are not neighbours, so that one of the two triangles on the line is always free; how to find
/// which is said at each walk.
class BridgeFinder {
 public:
  BridgeFinder(const Placement& placement, const FreeChains& chains)
      : place_(placement), a_(chains.a), b_(chains.b), last_a_(chains.a.size() - 1), last_b_(chains.b.size() - 1) {}

  Bridge run() const {
    if (last_a_ < 2) throw StructureError("the hull of P has no free vertex");
    const Bridge lid = roll_from_corner();
    if (is_bridge(lid)) return lid;
    const Bridge mouth = roll_from_mouth();
    if (is_bridge(mouth)) return mouth;
    throw StructureError("no bridge between the two relative hulls");
  }

 private:
  int turn(VertexId a, VertexId b, VertexId c) const {
    return (a == b || b == c || c == a) ? 0 : place_.orientation(a, b, c);
  }

  /// Rolls the lid of the notch at z_b outwards, i along A and j along B, until it supports both chains. If the bridge
  /// ends on B or at z_a, this finds it: what it cuts off is bounded by the bridge and by the chains from z_b to its
  /// ends. What the lid has not passed of this has convex corners at the bridge's ends and at those ends of the lid
  /// from which a chain goes on outwards. Where both do, the triangle on A's next edge is an ear if and only if B's
  /// next vertex is beyond it: the outermost obstacle in the triangle would be joined to a_i by a diagonal, and the
  /// piece between them needs three convex corners; so it is B's, and B goes into the triangle at once.
  Bridge roll_from_corner() const {
    std::size_t i = 1, j = 1;
    for (;;) {
      checkpoint();
      const bool a_goes_on = i + 1 < last_a_ && turn(a_[i], b_[j], a_[i + 1]) > 0;
      const bool b_goes_on = j < last_b_ && turn(a_[i], b_[j], b_[j + 1]) > 0;
      if (a_goes_on && (!b_goes_on || turn(a_[i + 1], b_[j], b_[j + 1]) > 0)) {
        ++i;
      } else if (b_goes_on) {
        ++j;
      } else {
        return {i, j < last_b_ ? BridgeEnd::on_b : BridgeEnd::at_z_a, j};
      }
    }
  }

  /// Rolls the lid of the cavity inwards, between the two strands of A. If the bridge ends on A, this finds it: both
  /// notches are in one pocket of the convex hull, whose lid has both ends on A; the bridge, the lid and the strands
  /// from one to the other bound a pseudo-triangle. What the line has not passed of this has its convex corners at the
  /// line's ends and at the bridge's end. By the reason above, the triangle on the far strand's next edge is an ear
  /// unless the near strand goes into it at once.
  Bridge roll_from_mouth() const {
    auto [i, l] = ends_of_hull();
    while (l < last_a_ && i > 0 && turn(a_[i], a_[l], a_[l + 1]) < 0) {
      checkpoint();
      if (turn(a_[i], a_[l + 1], a_[i - 1]) > 0) {
        --i;
      } else {
        ++l;
      }
    }
    return {i, BridgeEnd::on_a, l};
  }

  /// The first and the last vertex of A on its convex hull, by Melkman's algorithm: a vertex that comes is inside the
  /// hull so far, or takes back some vertices at either end of it.
  std::pair<std::size_t, std::size_t> ends_of_hull() const {
    // Counterclockwise, the newest vertex at both ends; A turns left, so that its first triangle is the hull's.
    std::deque<std::size_t> hull{2, 0, 1, 2};
    const auto right_of = [this](std::size_t u, std::size_t v, std::size_t w) { return turn(a_[u], a_[v], a_[w]) < 0; };
    for (std::size_t k = 3; k <= last_a_; ++k) {
      checkpoint();
      if (!right_of(hull[0], hull[1], k) && !right_of(hull.end()[-2], hull.end()[-1], k)) continue;
      while (right_of(hull[0], hull[1], k)) hull.pop_front();
      while (right_of(hull.end()[-2], hull.end()[-1], k)) hull.pop_back();
      hull.push_front(k);
      hull.push_back(k);
    }
    const auto [first, last] = std::minmax_element(hull.begin(), hull.end());
    return {*first, *last};
  }

  bool on_right(VertexId y, VertexId x, VertexId v) const { return v == x || turn(y, x, v) < 0; }

  /// The definition: the edge supports the chains at its ends, and crosses neither.
  bool is_bridge(const Bridge& e) const {
    switch (e.end) {
      case BridgeEnd::on_b:
        return supports_b(e.from, e.to) && !crossed(a_[e.from], b_[e.to]);
      case BridgeEnd::at_z_a:
        return supports_end(e.from) && !crossed(a_[e.from], a_.back());
      default:
        return supports_mouth(e.from, e.to) && !crossed(a_[e.from], a_[e.to]);
    }
  }
  bool supports_b(std::size_t i, std::size_t j) const {
    const VertexId y = a_[i], q = b_[j];
    return turn(a_[i + 1], y, q) < 0 && on_right(y, q, a_[i - 1]) && on_right(y, q, b_[j + 1]) &&
           on_right(y, q, b_[j - 1]);
  }
  bool supports_end(std::size_t i) const {
    const VertexId y = a_[i], z = a_.back();
    return a_[i + 1] != z && turn(a_[i + 1], y, z) < 0 && on_right(y, z, a_[i - 1]) &&
           on_right(y, z, b_[last_b_ - 1]) && turn(y, z, a_[last_a_ - 1]) > 0;
  }
  bool supports_mouth(std::size_t i, std::size_t l) const {
    if (i == 0 || l <= i + 1 || l >= last_a_) return false;
    const VertexId y = a_[i], x = a_[l];
    return turn(a_[i + 1], y, x) < 0 && on_right(y, x, a_[i - 1]) && turn(y, x, a_[l + 1]) > 0 &&
           turn(y, x, a_[l - 1]) > 0;
  }
  /// Does a chain cross the open segment from y to x?
  bool crossed(VertexId y, VertexId x) const { return crossed_by(a_, y, x) || crossed_by(b_, y, x); }
  bool crossed_by(const std::vector<VertexId>& chain, VertexId y, VertexId x) const {
    VertexId v = chain.front();
    int side_v = turn(y, x, v);
    for (const VertexId w : chain) {
      checkpoint();
      const int side_w = turn(y, x, w);
      if (side_v * side_w < 0 && turn(v, w, y) * turn(v, w, x) < 0) return true;
      v = w;
      side_v = side_w;
    }
    return false;
  }

  const Placement& place_;
  const std::vector<VertexId>&a_, &b_;
  std::size_t last_a_, last_b_;
};

}  // namespace

Bridge find_bridge(const Placement& placement, const FreeChains& chains) {
  return BridgeFinder(placement, chains).run();
}

}  // namespace taut::internal
