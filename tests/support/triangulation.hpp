// Triangulations of small sets of integer points: the soil on which random disjoint polygons grow.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "support/rng.hpp"

namespace taut::testing {

struct IntPoint {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const IntPoint& a, const IntPoint& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator<(const IntPoint& a, const IntPoint& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }
};

/// Twice the area of the triangle, exact for coordinates below 2^30.
inline std::int64_t cross(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Triangulation {
 public:
  using Triangle = std::array<int, 3>;  // counterclockwise

  /// All points must be distinct; not all on one line, or there is no triangle.
  explicit Triangulation(std::vector<IntPoint> points);

  /// Flips edges until the triangulation is (nearly) Delaunay.
  void make_delaunay();
  /// Flips up to `count` random edges, where the two triangles at an edge form a strictly convex quadrangle.
  void flip_randomly(Rng& rng, int count);

  const std::vector<IntPoint>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// The third vertex of the triangle to the left of the edge from a to b; -1 outside.
  int apex(int a, int b) const;

 private:
  void add(int a, int b, int c);
  /// Replaces the edge a-b by the other diagonal; false if the quadrangle is not strictly convex.
  bool flip(int a, int b);
  bool wants_flip(int a, int b) const;

  std::vector<IntPoint> points_;
  std::vector<Triangle> triangles_;
  std::map<std::pair<int, int>, int> left_;  // directed edge -> triangle to its left
};

}  // namespace taut::testing
