// The edges of a polygon by their heights, to find those that are near a point or a box.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "proof/curve_arc.hpp"

namespace taut::internal::proof {

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
