#include "comparison/convex_hierarchy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace taut::paper {
namespace {

class Sides {
 public:
  explicit Sides(const Polygon& ring) : ring_(ring) {}

  std::size_t count() const { return ring_.size(); }
  const Point& from(int side) const { return ring_[static_cast<std::size_t>(side)]; }
  const Point& to(int side) const { return ring_[(static_cast<std::size_t>(side) + 1) % ring_.size()]; }
  Point direction(int side) const { return {to(side).x - from(side).x, to(side).y - from(side).y}; }
  /// The angle from one side's direction to another's.
  double turn(int side, int other) const {
    const Point a = direction(side), b = direction(other);
    return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  /// Where the lines of two sides meet.
  Point meeting(int side, int other) const {
    if (to(side) == from(other)) return to(side);
    const Point a = direction(side), b = direction(other);
    const Point gap{from(other).x - from(side).x, from(other).y - from(side).y};
    const double share = (gap.x * b.y - gap.y * b.x) / (a.x * b.y - a.y * b.x);
    return {from(side).x + share * a.x, from(side).y + share * a.y};
  }
  /// How far a point is beyond the farthest of the lines of the sides between two others: 0 if there are none.
  double beyond(const Point& p, int side, int other) const {
    double most = 0;
    const int n = static_cast<int>(count());
    for (int k = (side + 1) % n; k != other; k = (k + 1) % n) {
      const Point d = direction(k);
      most = std::max(most, ((p.x - from(k).x) * d.y - (p.y - from(k).y) * d.x) / std::hypot(d.x, d.y));
    }
    return most;
  }

 private:
  const Polygon& ring_;
};

/// Without every other side, where the two beside it may meet.
std::vector<int> thinned(const Sides& sides, const std::vector<int>& kept) {
  constexpr double widest = 2 * std::numbers::pi / 3;
  std::vector<int> out;
  bool may_go = false;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const int next = kept[(k + 1) % kept.size()];
    const double turn = may_go ? sides.turn(out.back(), next) : 0;
    if (may_go && turn > 0 && turn <= widest) {
      may_go = false;
    } else {
      out.push_back(kept[k]);
      may_go = true;
    }
  }
  return out;
}

HierarchyLevel level_of(const Sides& sides, std::vector<int> kept) {
  HierarchyLevel out;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const int before = kept[(k + kept.size() - 1) % kept.size()];
    out.ring.push_back(sides.meeting(before, kept[k]));
    out.excess = std::max(out.excess, sides.beyond(out.ring.back(), before, kept[k]));
  }
  out.side = std::move(kept);
  return out;
}

}  // namespace

std::vector<HierarchyLevel> outer_hierarchy(const Polygon& ring) {
  const Sides sides(ring);
  std::vector<int> kept;
  for (std::size_t k = 0; k < sides.count(); ++k) kept.push_back(static_cast<int>(k));
  std::vector<HierarchyLevel> out;
  while (true) {
    out.push_back(level_of(sides, kept));
    std::vector<int> fewer = thinned(sides, kept);
    if (fewer.size() == kept.size() || fewer.size() < 3) break;
    kept = std::move(fewer);
  }
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace taut::paper
