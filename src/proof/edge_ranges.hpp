// The edges of a body: halved again and again, as a log speaks of them, and by their heights, to find those near a
// point or a box.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/displacement.hpp"
#include "geometry/vector.hpp"
#include "proof/curve_arc.hpp"

namespace taut::internal::proof {

/// Some edges, and a rectangle that certainly contains all of them as displaced: all centre + s along + t
/// turned(along) with |s| <= half_length and |t| <= half_width.
struct EdgeRange {
  Vector centre, along;  ///< along is a unit vector up to rounding
  double half_length = 0, half_width = 0;
  std::uint32_t first = 0, count = 0;  ///< of a run of edges: the first one's first vertex, and how many
  std::uint32_t halves[2] = {0, 0};    ///< unused where count is 1

  bool single() const { return count == 1; }
  /// How far its points are from the centre, at most.
  double radius() const { return half_length + half_width; }
};

/// A tree of ranges. Several rings are halved by their order along the longer side of the box around them, a ring by
/// the order of its edges: docs/proof-format.md. Nothing of this is taken from an engine.
class EdgeRanges {
 public:
  explicit EdgeRanges(const DisplacedPolygon& body);
  static constexpr std::uint32_t all = 0;
  const EdgeRange& operator[](std::uint32_t i) const { return ranges_[i]; }

 private:
  std::uint32_t add_rings(const DisplacedPolygon& body, std::span<RingSpan> rings);
  std::uint32_t add_run(const DisplacedPolygon& body, const RingSpan& ring, std::uint32_t first, std::uint32_t count);

  std::vector<EdgeRange> ranges_;
};

// The edges of a polygon by their heights, to find those that are near a point or a box.

/// Numbers between which something certainly is.
struct Extent {
  double lo = 0, hi = 0;
};

class EdgeSlabs {
 public:
  explicit EdgeSlabs(const Polygon& polygon);

  std::size_t size() const { return polygon_.size(); }
  const Point& begin(std::size_t e) const { return polygon_[e]; }
  const Point& end(std::size_t e) const { return polygon_[e + 1 == polygon_.size() ? 0 : e + 1]; }

  /// Calls `visit` with every edge that may meet the box, some of them more than once, until it returns false; false
  /// then.
  template <class Visit>
  bool all_near(const Extent& x, const Extent& y, const Visit& visit) const {
    const std::size_t last = slab_of(y.hi);
    for (std::size_t s = slab_of(y.lo); s <= last; ++s) {
      for (const std::uint32_t e : slabs_[s]) {
        const Point &a = begin(e), &b = end(e);
        if (std::max(a.x, b.x) < x.lo || std::min(a.x, b.x) > x.hi) continue;
        if (std::max(a.y, b.y) < y.lo || std::min(a.y, b.y) > y.hi) continue;
        if (!visit(e)) return false;
      }
    }
    return true;
  }

  /// Is the point inside of the polygon? Nothing if that is not certain.
  std::optional<bool> contains(const CurvePoint& z) const;

 private:
  /// Grows with y, so that an edge at the height of a point is in the point's slab.
  std::size_t slab_of(double y) const {
    const double k = std::floor((y - lowest_) * scale_);
    if (!(k > 0)) return 0;
    return k >= static_cast<double>(count_) ? count_ - 1 : static_cast<std::size_t>(k);
  }
  /// How often edges would be listed.
  std::size_t listed() const;

  const Polygon& polygon_;
  double lowest_ = 0, scale_ = 0;
  std::size_t count_ = 1;
  std::vector<std::vector<std::uint32_t>> slabs_;
};

/// 1 if the edge from a to b passes the ray from z to the right upwards, -1 downwards, else 0; nothing if that is not
/// certain. Summed up over a closed polygon, it is how often that winds around z.
std::optional<int> passage(const CurvePoint& a, const CurvePoint& b, const CurvePoint& z);

/// The interval in which all of these coordinates are.
template <class Coordinate>
Extent extent_of(const CurvePoint* points, int count, const Coordinate& coordinate) {
  Extent extent{INFINITY, -INFINITY};
  for (int i = 0; i < count; ++i) {
    const CurveNumber& x = coordinate(points[i]);
    const double lo = double_below(x.lower()), hi = double_above(x.upper());
    if (!std::isfinite(lo) || !std::isfinite(hi)) return {-INFINITY, INFINITY};
    extent = {std::min(extent.lo, lo), std::max(extent.hi, hi)};
  }
  return extent;
}

}  // namespace taut::internal::proof
