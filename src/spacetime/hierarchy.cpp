#include "spacetime/hierarchy.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal::spacetime {
namespace {

/// Approximately the unit vector from a to b; (1, 0) if they are equal.
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
  // Projections and the centre are rounded a few times each, relative to the size of the coordinates. The vector u is a
  // unit vector up to rounding. The displacement is added.
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

namespace {

AxisBox bounds_of(const DisplacedPolygon& body, const RingSpan& ring) {
  return box_around(std::span(body.points).subspan(ring.first, ring.count));
}

/// An axis-parallel box around several rings.
Box box_of_rings(const DisplacedPolygon& body, std::span<const RingSpan> rings) {
  std::vector<DisplacedPoint> corners;
  for (const RingSpan& ring : rings) {
    const AxisBox b = bounds_of(body, ring);
    corners.push_back({b.lo_x, b.lo_y, 0, 0});
    corners.push_back({b.hi_x, b.hi_y, 0, 0});
  }
  // A run that returns to its beginning has the axes as its directions.
  return box_of_run(corners, 0, static_cast<std::uint32_t>(corners.size()));
}

}  // namespace

Hierarchy::Hierarchy(std::span<const DisplacedPoint> polygon) {
  nodes_.reserve(2 * polygon.size());
  build(polygon, 0, 0, static_cast<std::uint32_t>(polygon.size()));
  around_ = disc_around(polygon);
}

Hierarchy::Hierarchy(const DisplacedPolygon& body) {
  nodes_.reserve(2 * body.points.size());
  std::vector<RingSpan> rings = body.rings;
  if (rings.empty()) rings.push_back({0, static_cast<std::uint32_t>(body.points.size()), false});
  for (const RingSpan& ring : rings) {
    if (!ring.hole) continue;
    const Disc disc = disc_within(std::span(body.points).subspan(ring.first, ring.count));
    if (disc.radius > 0) hollows_.push_back({ring.first, ring.count, disc});
  }
  build(body, rings);
  around_ = disc_around(body.points);
}

const Disc* Hierarchy::hollow_with(std::uint32_t edge) const {
  const auto next = std::upper_bound(hollows_.begin(), hollows_.end(), edge,
                                     [](std::uint32_t e, const Hollow& hollow) { return e < hollow.first; });
  if (next == hollows_.begin()) return nullptr;
  const Hollow& hollow = *(next - 1);
  return edge - hollow.first < hollow.count ? &hollow.disc : nullptr;
}

Hierarchy hierarchy_of_p(const PairGeometry& g) { return Hierarchy(*g.p()); }
Hierarchy hierarchy_of_q(const PairGeometry& g) { return Hierarchy(*g.q()); }

std::uint32_t Hierarchy::build(std::span<const DisplacedPoint> ring, std::uint32_t offset, std::uint32_t first,
                               std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({box_of_run(ring, first, count), offset + first, count, 0, 0});
  if (count > 1) {
    const std::uint32_t left = build(ring, offset, first, count / 2);
    const std::uint32_t right = build(ring, offset, first + count / 2, count - count / 2);
    nodes_[index].left = left;
    nodes_[index].right = right;
  }
  return index;
}

/// Rings are divided at the median of their middles, along the longer side.
std::uint32_t Hierarchy::build(const DisplacedPolygon& body, std::span<RingSpan> rings) {
  if (rings.size() == 1) {
    const RingSpan& ring = rings[0];
    return build(std::span(body.points).subspan(ring.first, ring.count), ring.first, 0, ring.count);
  }
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  std::uint32_t count = 0;
  for (const RingSpan& ring : rings) count += ring.count;
  nodes_.push_back({box_of_rings(body, rings), no_first, count, 0, 0});
  const bool along_x = nodes_[index].box.half_length >= nodes_[index].box.half_width;
  const auto key = [&](const RingSpan& ring) {
    const AxisBox b = bounds_of(body, ring);
    return along_x ? b.lo_x + b.hi_x : b.lo_y + b.hi_y;
  };
  const auto half = static_cast<std::ptrdiff_t>(rings.size() / 2);
  std::nth_element(rings.begin(), rings.begin() + half, rings.end(), [&](const RingSpan& a, const RingSpan& b) {
    const double ka = key(a), kb = key(b);
    return ka != kb ? ka < kb : a.first < b.first;
  });
  const std::uint32_t left = build(body, rings.first(static_cast<std::size_t>(half)));
  const std::uint32_t right = build(body, rings.subspan(static_cast<std::size_t>(half)));
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

}  // namespace taut::internal::spacetime
