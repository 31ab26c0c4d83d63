// Polygons on integers: simplicity and disjointness by brute force, exact.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/triangulation.hpp"

namespace taut::testing {

using IntPolygon = std::vector<IntPoint>;

inline bool on_segment(const IntPoint& a, const IntPoint& b, const IntPoint& p) {
  return cross(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

inline int side(const IntPoint& a, const IntPoint& b, const IntPoint& p) {
  const std::int64_t d = cross(a, b, p);
  return (d > 0) - (d < 0);
}

inline bool cross_properly(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

inline bool meet(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d) {
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b) ||
         cross_properly(a, b, c, d);
}

/// Every pair of edges, exactly: only neighbours meet, in one point.
inline bool is_simple(const IntPolygon& p) {
  const std::size_t n = p.size();
  if (n < 3) return false;
  const auto at = [&](std::size_t i) -> const IntPoint& { return p[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (on_segment(at(i), at(i + 1), at(i + 2)) || on_segment(at(i + 1), at(i + 2), at(i))) return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) && meet(at(i), at(i + 1), at(j), at(j + 1))) return false;
  }
  return true;
}

inline std::int64_t area2(const IntPolygon& p) {
  std::int64_t a = 0;
  for (std::size_t i = 0; i < p.size(); ++i) a += cross(p[0], p[i], p[(i + 1) % p.size()]);
  return a;
}

/// For points that are not on the boundary.
inline bool contains(const IntPolygon& p, const IntPoint& c) {
  bool inside = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const IntPoint &a = p[i], &b = p[(i + 1) % p.size()];
    if ((a.y > c.y) != (b.y > c.y) && (cross(a, b, c) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

/// No common point of the closures.
inline bool are_disjoint(const IntPolygon& p, const IntPolygon& q) {
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      if (meet(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()])) return false;
  return !contains(p, q[0]) && !contains(q, p[0]);
}

}  // namespace taut::testing
