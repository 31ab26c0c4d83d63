#include "spacetime/hierarchy.hpp"

#include <algorithm>
#include <cmath>

namespace taut::spacetime {
namespace {

/// About the unit vector from a to b; (1, 0) if they are the same.
Point direction(const DisplacedPoint& a, const DisplacedPoint& b) {
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

Box box_of_run(const PairGeometry& g, std::uint32_t first, std::uint32_t count) {
  VertexId last(first);
  for (std::uint32_t k = 0; k < count; ++k) last = g.next(last);
  Box box;
  const Point u = direction(g.point(VertexId(first)), g.point(last)), v{-u.y, u.x};
  Extent along, across;
  double size = 0;
  VertexId id(first);
  for (std::uint32_t k = 0; k <= count; ++k, id = g.next(id)) {
    const DisplacedPoint& p = g.point(id);
    along.add(u.x * p.x + u.y * p.y);
    across.add(v.x * p.x + v.y * p.y);
    size = std::max(size, std::fabs(p.x) + std::fabs(p.y));
  }
  // Projections and corners round a few times each, relative to the size of the coordinates; u is a unit vector up to
  // rounding; the displacement is below 2^-157.
  const double padding = 0x1p-47 * size + 0x1p-150;
  along.pad(padding);
  across.pad(padding);
  const auto corner = [&](double s, double t) { return Point{u.x * s + v.x * t, u.y * s + v.y * t}; };
  box.corners = {corner(along.lo, across.lo), corner(along.hi, across.lo), corner(along.hi, across.hi),
                 corner(along.lo, across.hi)};
  box.along = u;
  box.across = v;
  box.size = (along.hi - along.lo) + (across.hi - across.lo);
  return box;
}

Hierarchy::Hierarchy(const PairGeometry& g, bool of_p) {
  nodes_.reserve(2 * (of_p ? g.np : g.nq));
  build(g, of_p ? 0 : g.np, of_p ? g.np : g.nq);
}

std::uint32_t Hierarchy::build(const PairGeometry& g, std::uint32_t first, std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({box_of_run(g, first, count), first, count, 0, 0});
  if (count > 1) {
    const std::uint32_t left = build(g, first, count / 2);
    const std::uint32_t right = build(g, first + count / 2, count - count / 2);
    nodes_[index].left = left;
    nodes_[index].right = right;
  }
  return index;
}

}  // namespace taut::spacetime
