// A rectangle along the axes: the one type for it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {

/// Closed; empty at first, so that it can be grown by what it is to hold. Nothing is rounded but where it is said.
struct AxisBox {
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;

  AxisBox() = default;
  constexpr AxisBox(double low_x, double low_y, double high_x, double high_y)
      : lo_x(low_x), lo_y(low_y), hi_x(high_x), hi_y(high_y) {}
  /// Around two points, with a margin that is rounded to nearest.
  AxisBox(const Point& a, const Point& b, double margin = 0)
      : AxisBox(std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::max(a.x, b.x) + margin,
                std::max(a.y, b.y) + margin) {}

  void include(double x, double y) {
    lo_x = std::min(lo_x, x);
    lo_y = std::min(lo_y, y);
    hi_x = std::max(hi_x, x);
    hi_y = std::max(hi_y, y);
  }
  void include(const Point& p) { include(p.x, p.y); }
  void include(const AxisBox& o) {
    lo_x = std::min(lo_x, o.lo_x);
    lo_y = std::min(lo_y, o.lo_y);
    hi_x = std::max(hi_x, o.hi_x);
    hi_y = std::max(hi_y, o.hi_y);
  }
  bool meets(const AxisBox& o) const {
    // Without a branch: any of the four is as likely to fail.
    return static_cast<bool>(static_cast<int>(lo_x <= o.hi_x) & static_cast<int>(o.lo_x <= hi_x) &
                             static_cast<int>(lo_y <= o.hi_y) & static_cast<int>(o.lo_y <= hi_y));
  }
  bool holds(const AxisBox& o) const { return lo_x <= o.lo_x && lo_y <= o.lo_y && hi_x >= o.hi_x && hi_y >= o.hi_y; }
  double width() const { return hi_x - lo_x; }
  double height() const { return hi_y - lo_y; }
  double longest() const { return std::max(width(), height()); }
  /// 0 if and only if they meet; else rounded.
  double distance_to(const AxisBox& o) const {
    const double x = std::max({0.0, lo_x - o.hi_x, o.lo_x - hi_x}), y = std::max({0.0, lo_y - o.hi_y, o.lo_y - hi_y});
    return std::sqrt(x * x + y * y);
  }
};

/// The least box that holds the points; empty if there are none.
template <class Points>
AxisBox box_around(const Points& points) {
  AxisBox box;
  for (const auto& p : points) box.include(p.x, p.y);
  return box;
}

/// The length of its diagonal, rounded; 0 for an empty box.
inline double diagonal(const AxisBox& box) {
  const double x = box.width(), y = box.height(), m = std::max(x, y);
  return m > 0 ? m * std::sqrt((x / m) * (x / m) + (y / m) * (y / m)) : 0;
}

}  // namespace taut::internal
