// Points, polygons and parts as a user writes them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

// MSVC tells the language in a macro of its own.
#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 202002L
#error "taut needs C++20: compile with -std=c++20, or /std:c++20"
#endif

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

/// The layers that a shape reaches through: an interval of heights across the plane, in the scene's units of length;
/// all layers if nothing else is said. Two shapes can meet only where the insides of their intervals do, however
/// touching is read: plates that lie flush on each other slide on each other, and that is no contact.
struct Layers {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();

  /// Do the insides of the two intervals have a height in common?
  bool meet(const Layers& o) const { return std::max(lo, o.lo) < std::min(hi, o.hi); }
  friend bool operator==(const Layers& a, const Layers& b) { return a.lo == b.lo && a.hi == b.hi; }
};

/// A connected piece of material: a polygon minus holes. The closed insides of the holes lie in the inside of the
/// outline, and no two of them touch. Each ring may be given in either orientation.
struct Part {
  Polygon outline;
  std::vector<Polygon> holes;
  std::optional<Layers> z = {};  ///< its own layers, in place of those of its body
};

}  // namespace taut
