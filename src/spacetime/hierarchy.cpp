#include "spacetime/hierarchy.hpp"

#include <algorithm>
#include <cmath>

namespace taut::spacetime {
namespace {

/// About the unit vector from a to b; (1, 0) if they are the same.
Vector direction(const DisplacedPoint& a, const DisplacedPoint& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double m = std::max(std::fabs(x), std::fabs(y));
  if (!(m > 0)) return {1, 0};
  const double ux = x / m, uy = y / m, length = std::sqrt(ux * ux + uy * uy);
  return {ux / length, uy / length};
}

struct Extent {
  double lo = INFINITY, hi = -INFINITY;
  void add(double x) {
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
  void pad(double by) {
    lo -= by;
    hi += by;
  }
};

}  // namespace

Box box_of_run(std::span<const DisplacedPoint> polygon, std::uint32_t first, std::uint32_t count) {
  const std::size_t last = (first + count) % polygon.size();
  const Vector u = direction(polygon[first], polygon[last]);
  Extent along, across;
  double largest = 0;
  const auto add = [&](const DisplacedPoint& p) {
    along.add(u.x * p.x + u.y * p.y);
    across.add(u.x * p.y - u.y * p.x);
    largest = std::max(largest, std::fabs(p.x) + std::fabs(p.y));
  };
  for (std::uint32_t i = first; i < first + count; ++i) add(polygon[i]);
  add(polygon[last]);
  // Projections and the centre round a few times each, relative to the size of the coordinates; u is a unit vector up
  // to rounding; then there is the displacement.
  const double padding = 0x1p-47 * largest + displacement_room;
  along.pad(padding);
  across.pad(padding);
  Box box;
  box.along = u;
  box.half_length = (along.hi - along.lo) / 2;
  box.half_width = (across.hi - across.lo) / 2;
  box.centre = u * Vector{along.lo + box.half_length, across.lo + box.half_width};
  const double square = box.half_length * box.half_length + box.half_width * box.half_width;
  box.radius = std::sqrt(square) * (1 + 0x1p-48) + underflow_slack;
  return box;
}

Hierarchy::Hierarchy(std::span<const DisplacedPoint> polygon) {
  nodes_.reserve(2 * polygon.size());
  build(polygon, 0, static_cast<std::uint32_t>(polygon.size()));
}

Hierarchy hierarchy_of_p(const PairGeometry& g) { return Hierarchy(g.p()->points); }
Hierarchy hierarchy_of_q(const PairGeometry& g) { return Hierarchy(g.q()->points); }

std::uint32_t Hierarchy::build(std::span<const DisplacedPoint> polygon, std::uint32_t first, std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({box_of_run(polygon, first, count), first, count, 0, 0});
  if (count > 1) {
    const std::uint32_t left = build(polygon, first, count / 2);
    const std::uint32_t right = build(polygon, first + count / 2, count - count / 2);
    nodes_[index].left = left;
    nodes_[index].right = right;
  }
  return index;
}

}  // namespace taut::spacetime
