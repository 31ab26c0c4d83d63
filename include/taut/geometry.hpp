// Points, polygons and parts as a user writes them.
#pragma once

#include <cstdint>
#include <vector>

namespace taut {

/// A point of the plane; the two doubles mean exactly what they say.
struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
  friend bool operator!=(const Point& a, const Point& b) { return !(a == b); }
};

/// The vertices of a simple polygon in either orientation, the first one not repeated at the end.
/// Edge j joins vertices j and j+1 (modulo the number of vertices).
using Polygon = std::vector<Point>;

/// A connected piece of material: a polygon minus holes. The closed insides of the holes lie in the inside of the
/// outline, and no two of them touch. Each ring may be given in either orientation.
struct Part {
  Polygon outline;
  std::vector<Polygon> holes;
};

}  // namespace taut
