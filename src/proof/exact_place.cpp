#include "proof/exact_place.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"

namespace taut::internal::proof {
namespace {

/// Is p on the closed segment?
bool is_on(const ExactPlace& p, const ExactPlace& a, const ExactPlace& b) {
  return dot(a - p, b - p).sign() <= 0 && turn_of(a, b, p) == 0;
}

/// Certainly holds the segment.
AxisBox bounds_of(const ExactPlace& p, const ExactPlace& q) {
  const Point a{nearest_double(p.x), nearest_double(p.y)}, b{nearest_double(q.x), nearest_double(q.y)};
  const double size = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
  return {a, b, 0x1p-48 * size + 0x1p-1000};
}

/// An edge of a ring that comes near a segment.
struct NearEdge {
  ExactPlace from, to;
};

std::vector<NearEdge> edges_near(const std::vector<Polygon>& rings, const AxisBox& around) {
  std::vector<NearEdge> edges;
  for (const Polygon& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
      if (around.meets(AxisBox(a, b))) edges.push_back({ExactPlace::of(a), ExactPlace::of(b)});
    }
  }
  return edges;
}

/// Does the edge from a to b cross a horizontal line to the right of p, where p is not on it?
bool crosses_right_of(const ExactPlace& p, const ExactPlace& a, const ExactPlace& b) {
  const bool up = (b.y - p.y).sign() > 0;
  if (((a.y - p.y).sign() > 0) == up) return false;
  return turn_of(a, b, p) == (up ? 1 : -1);
}

/// In the closed polygon with holes: on a boundary, or inside by the number of edges to the right.
bool holds_place(const std::vector<Polygon>& rings, const ExactPlace& p) {
  const AxisBox at = bounds_of(p, p);
  bool inside = false;
  for (const NearEdge& edge : edges_near(rings, {at.lo_x, at.lo_y, INFINITY, at.hi_y})) {
    if (is_on(p, edge.from, edge.to)) return true;
    if (crosses_right_of(p, edge.from, edge.to)) inside = !inside;
  }
  return inside;
}

/// Of two numbers, the second one positive.
struct Fraction {
  Dyadic above, below;
};

/// The shares of the way from p to q at which a closed polygon's edges may cross it, begin or end on it; 0 and 1.
std::vector<Fraction> cuts_of(const std::vector<ExactPlace>& polygon, const ExactPlace& p, const ExactPlace& q) {
  const Dyadic one(1, 0);
  std::vector<Fraction> cuts = {{Dyadic(), one}, {one, one}};
  const ExactPlace along = q - p;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPlace &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Dyadic at_a = cross(along, a - p), at_b = cross(along, b - p);
    if (at_a.is_zero() && is_on(a, p, q) && p != q) cuts.push_back({dot(along, a - p), dot(along, along)});
    if (at_a.sign() * at_b.sign() >= 0 || turn_of(a, b, p) * turn_of(a, b, q) >= 0) continue;
    const Dyadic below = cross(along, b - a), above = cross(a - p, b - a);
    cuts.push_back(below.sign() > 0 ? Fraction{above, below} : Fraction{-above, -below});
  }
  return cuts;
}

}  // namespace

Dyadic dot(const ExactPlace& a, const ExactPlace& b) { return a.x * b.x + a.y * b.y; }
Dyadic cross(const ExactPlace& a, const ExactPlace& b) { return a.x * b.y - a.y * b.x; }

int turn_of(const ExactPlace& a, const ExactPlace& b, const ExactPlace& p) { return cross(b - a, p - a).sign(); }

bool segments_meet(const ExactPlace& a, const ExactPlace& b, const ExactPlace& c, const ExactPlace& d) {
  if (is_on(a, c, d) || is_on(b, c, d) || is_on(c, a, b) || is_on(d, a, b)) return true;
  return turn_of(a, b, c) * turn_of(a, b, d) < 0 && turn_of(c, d, a) * turn_of(c, d, b) < 0;
}

bool is_on_or_beside(const std::vector<ExactPlace>& polygon, const ExactPlace& p, const ExactPlace& q, bool odd) {
  std::vector<Fraction> cuts = cuts_of(polygon, p, q);
  std::sort(cuts.begin(), cuts.end(),
            [](const Fraction& a, const Fraction& b) { return (a.above * b.below - b.above * a.below).sign() < 0; });
  // Between two cuts, all points are on an edge, or none is on any, and all have as many to their right.
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    checkpoint();
    const Dyadic above = cuts[i].above * cuts[i + 1].below + cuts[i + 1].above * cuts[i].below,
                 below = cuts[i].below * cuts[i + 1].below + cuts[i].below * cuts[i + 1].below;
    // All is larger by `below`, so that nothing is divided.
    std::vector<ExactPlace> larger;
    for (const ExactPlace& corner : polygon) larger.push_back(below * corner);
    const ExactPlace middle = below * p + above * (q - p);
    if (!is_on_edge(larger, middle) && is_odd(larger, middle) != odd) return false;
  }
  return true;
}

bool is_on_edge(const std::vector<ExactPlace>& polygon, const ExactPlace& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (is_on(p, polygon[i], polygon[(i + 1) % polygon.size()])) return true;
  }
  return false;
}

bool is_odd(const std::vector<ExactPlace>& polygon, const ExactPlace& p) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (crosses_right_of(p, polygon[i], polygon[(i + 1) % polygon.size()])) odd = !odd;
  }
  return odd;
}

/// No edge crosses the segment from side to side. So between its ends and the vertices on it, in order, each piece is
/// on an edge, or meets none: where its middle is, all of it is.
bool holds_segment(const std::vector<Polygon>& rings, const ExactPlace& p, const ExactPlace& q, bool strictly) {
  std::vector<ExactPlace> places = {p, q};
  for (const NearEdge& edge : edges_near(rings, bounds_of(p, q))) {
    if (strictly && segments_meet(p, q, edge.from, edge.to)) return false;
    if (turn_of(p, q, edge.from) * turn_of(p, q, edge.to) < 0 &&
        turn_of(edge.from, edge.to, p) * turn_of(edge.from, edge.to, q) < 0)
      return false;
    if (is_on(edge.from, p, q)) places.push_back(edge.from);
  }
  const ExactPlace along = q - p;
  std::sort(places.begin(), places.end(),
            [&](const ExactPlace& a, const ExactPlace& b) { return dot(along, a - b).sign() < 0; });
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const ExactPlace sum = places[i] + places[i + 1];
    if (!holds_place(rings, {sum.x.halved(), sum.y.halved()})) return false;
  }
  return true;
}

}  // namespace taut::internal::proof
