// Points whose coordinates are exact numbers, as a verifier needs them: what is on which side, and what is where.
#pragma once

#include <vector>

#include "geometry/axis_box.hpp"
#include "numeric/dyadic.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::proof {

/// A point, or a vector.
struct ExactPlace {
  Dyadic x, y;

  static ExactPlace of(const Point& p) { return {Dyadic::exact(p.x), Dyadic::exact(p.y)}; }
  bool is_zero() const { return x.is_zero() && y.is_zero(); }
  friend ExactPlace operator+(const ExactPlace& a, const ExactPlace& b) { return {a.x + b.x, a.y + b.y}; }
  friend ExactPlace operator-(const ExactPlace& a, const ExactPlace& b) { return {a.x - b.x, a.y - b.y}; }
  friend ExactPlace operator*(const Dyadic& s, const ExactPlace& v) { return {s * v.x, s * v.y}; }
  friend bool operator==(const ExactPlace& a, const ExactPlace& b) { return a.x == b.x && a.y == b.y; }
};

Dyadic dot(const ExactPlace& a, const ExactPlace& b);
Dyadic cross(const ExactPlace& a, const ExactPlace& b);

/// The sign of (b - a) x (p - a).
int turn_of(const ExactPlace& a, const ExactPlace& b, const ExactPlace& p);
/// Do the closed segments have a point in common? Their ends may be the same.
bool segments_meet(const ExactPlace& a, const ExactPlace& b, const ExactPlace& c, const ExactPlace& d);

/// Is p on one of the closed polygon's edges?
bool is_on_edge(const std::vector<ExactPlace>& polygon, const ExactPlace& p);
/// The closed polygon has an odd number of edges that cross the horizontal line to the right of p, which is on none of
/// its edges. Of a simple polygon: p is inside.
bool is_odd(const std::vector<ExactPlace>& polygon, const ExactPlace& p);
/// Is each point of the closed segment from p to q, whose ends may be the same, on the closed polygon, or is the number
/// of edges to its right as said?
bool is_on_or_beside(const std::vector<ExactPlace>& polygon, const ExactPlace& p, const ExactPlace& q, bool odd);

/// Is all of the closed segment in the polygon with holes? `strictly`: not on its boundary either. The first ring is
/// the outline, the others are holes; they meet each other, and themselves, in nothing but vertices.
bool holds_segment(const std::vector<Polygon>& rings, const ExactPlace& p, const ExactPlace& q, bool strictly);

}  // namespace taut::internal::proof
