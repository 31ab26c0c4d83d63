#include "geometry/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/vector.hpp"
#include "numeric/exact_sum.hpp"

namespace taut::internal {
namespace {

/// From one point to another: its direction, and its length up to a factor of 1 + 2^-50.
struct Edge {
  Point from, to;
  Vector unit;
  double length;

  Edge(const Point& a, const Point& b) : from(a), to(b) {
    // Scale first: a short edge of a small polygon must not underflow when squared.
    double x = b.x - a.x, y = b.y - a.y;
    const double m = std::max(std::fabs(x), std::fabs(y));
    x /= m;
    y /= m;
    const double scaled = std::sqrt(x * x + y * y);
    unit = {x / scaled, y / scaled};
    length = scaled * m;
  }
};

/// Adds sign * (to - from) * factor, exactly.
template <std::size_t Terms>
void add_difference(ExactSum<Terms>& sum, double from, double to, double factor) {
  sum.add_product(to, factor);
  sum.subtract_product(from, factor);
}

/// How far d moves the line of an edge to its left, up to a factor of 1 + 2^-49: exact before the division.
double shift_of(const Edge& e, const Vector& d) {
  ExactSum<16> sum;
  add_difference(sum, e.from.x, e.to.x, d.y);
  add_difference(sum, e.from.y, e.to.y, -d.x);
  return sum.approximate() / e.length;
}

/// How a vertex moves, in units of delta. Its edges are to move to their left by r1 and r2; the normals of the edges
/// are their directions turned by +90 degrees, so these are two linear equations for d. In the basis of the two
/// directions they are solved by d = (r1 on - r2 in) / sin, where sin is the sine of the turn at the vertex. At a spike
/// d runs along it, by about 3 / sin. Directions are rounded by 2^-52, which changes the shifts by 2^-50 / sin, less
/// than 0.05 down to sin = 2^-45; d reaches its limit before.
Vector corner_displacement(const Edge& in, const Edge& on, double side, std::uint64_t seed, std::size_t i) {
  const double sine = in.unit.x * on.unit.y - in.unit.y * on.unit.x;
  const double cosine = in.unit.x * on.unit.x + in.unit.y * on.unit.y;
  if (std::fabs(sine) <= 0.05 && cosine > 0) {
    // Nearly straight: along the mean normal, with a random slide.
    const double slide = random_between(~seed + i, -0.3, 0.3);
    const double r = side * random_between(seed + 2 * i, 1.3, 1.7);
    return {-r * on.unit.y + slide * on.unit.x, r * on.unit.x + slide * on.unit.y};
  }
  const double r1 = side * random_between(seed + 2 * i, 1.05, 1.95);
  const double r2 = side * random_between(seed + 2 * i + 1, 1.05, 1.95);
  const double alpha = -r2 / sine, beta = r1 / sine;
  return {alpha * in.unit.x + beta * on.unit.x, alpha * in.unit.y + beta * on.unit.y};
}

/// Are both edges moved by between delta and 2 delta, and the vertex within the limit? Blunt corners need no test: see
/// corner_displacement().
bool keeps_the_law(const Edge& in, const Edge& on, const Vector& d, double side, double delta) {
  const double way = std::max(std::fabs(d.x), std::fabs(d.y));
  if (way < 0x1p20 * delta) return true;
  if (!(way < displacement_limit / displacement_unit * delta)) return false;
  for (const Edge* e : {&in, &on}) {
    const double shift = side * shift_of(*e, d) / delta;
    if (!(shift > 1 + 0x1p-40 && shift < 2 - 0x1p-40)) return false;
  }
  return true;
}

}  // namespace

/// SplitMix64.
double random_between(std::uint64_t key, double lo, double hi) {
  std::uint64_t z = key + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return lo + (hi - lo) * (static_cast<double>(z >> 11) * 0x1p-53);
}

DisplacedPolygon::DisplacedPolygon(std::vector<DisplacedPoint> vertices, std::optional<DisplacementFault> found)
    : points(std::move(vertices)), fault(found) {
  if (points.empty()) return;
  bounds = box_around(points);
  largest = std::max(std::max(-bounds.lo_x, bounds.hi_x), std::max(-bounds.lo_y, bounds.hi_y));
}

DisplacedPolygon::DisplacedPolygon(std::vector<DisplacedPoint> vertices, std::vector<RingSpan> spans)
    : DisplacedPolygon(std::move(vertices)) {
  if (spans.size() == 1) return;
  rings = std::move(spans);
  next.resize(points.size());
  previous.resize(points.size());
  for (const RingSpan& ring : rings) {
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const std::uint32_t after = ring.first + (k + 1) % ring.count;
      next[ring.first + k] = after;
      previous[after] = ring.first + k;
    }
  }
}

Displacement displace(std::span<const Point> polygon, Offset offset, double delta, std::uint64_t seed) {
  const std::size_t n = polygon.size();
  const double side = offset == Offset::inward ? 1.0 : -1.0;
  Displacement out;
  out.points.reserve(n);
  double farthest = 0;
  Edge in(polygon[n - 1], polygon[0]);
  for (std::size_t i = 0; i < n; ++i) {
    const Point& v = polygon[i];
    const Edge on(v, polygon[i + 1 == n ? 0 : i + 1]);
    const Vector unscaled = corner_displacement(in, on, side, seed, i);
    Vector d{delta * unscaled.x, delta * unscaled.y};
    if (!keeps_the_law(in, on, d, side, delta)) {
      if (!out.too_sharp) out.too_sharp = static_cast<std::uint32_t>(i);
      d = {0, 0};
    }
    farthest = std::max({farthest, std::fabs(d.x), std::fabs(d.y)});
    out.points.push_back({v.x, v.y, d.x, d.y});
    in = on;
  }
  out.farthest = 1.5 * farthest;
  return out;
}

SharedPolygon displaced_polygon(const std::vector<Point>& polygon, Offset offset, std::uint64_t seed) {
  Displacement moved = displace(polygon, offset, displacement_unit, seed);
  std::optional<DisplacementFault> fault;
  if (moved.too_sharp) {
    fault = {DisplacementFault::Kind::sharp_corner, *moved.too_sharp, 0};
  } else if (!has_room(polygon, moved.farthest)) {
    fault = find_displacement_fault(moved.points, offset, moved.farthest);
  }
  return std::make_shared<const DisplacedPolygon>(std::move(moved.points), fault);
}

namespace {

/// a x b + b x c + c x a over chosen parts of the coordinates: part 0 is the input's point, part 1 the displacement.
template <class Sum>
void add_cross(Sum& sum, const DisplacedPoint& a, int part_a, const DisplacedPoint& b, int part_b) {
  const double ax = part_a ? a.dx : a.x, ay = part_a ? a.dy : a.y;
  const double bx = part_b ? b.dx : b.x, by = part_b ? b.dy : b.y;
  sum.add_product(ax, by);
  sum.subtract_product(ay, bx);
}

template <class Sum>
void add_level(Sum& sum, const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c, int i, int j) {
  add_cross(sum, a, i, b, j);
  add_cross(sum, b, i, c, j);
  add_cross(sum, c, i, a, j);
}

/// Exact where it is not rounded.
struct Difference {
  double value;
  bool rounded;
};
Difference difference(double a, double b) {
  const TwoDoubles d = two_sum(a, -b);
  return {d.hi, d.lo != 0};
}

/// Most points that doubles do not decide to turn are in line before the displacement, and differences of coordinates
/// on a grid are numbers of a few digits. Then the input's part of the determinant is known but for its last digits, or
/// to be zero, and what the displacement adds is its linear part, nearly. 0 where this does not decide.
int orientation_nearly_in_line(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c) {
  const Difference ux = difference(b.x, a.x), uy = difference(b.y, a.y);
  const Difference vx = difference(c.x, a.x), vy = difference(c.y, a.y);
  if (ux.rounded || uy.rounded || vx.rounded || vy.rounded) return 0;
  const TwoDoubles left = two_product(ux.value, vy.value), right = two_product(uy.value, vx.value);
  const double given = (left.hi - right.hi) + (left.lo - right.lo);
  const bool in_line = left.hi == right.hi && left.lo == right.lo;
  const double given_size = in_line ? 0 : std::fabs(left.hi - right.hi) + std::fabs(left.lo) + std::fabs(right.lo);
  const double dux = b.dx - a.dx, duy = b.dy - a.dy, dvx = c.dx - a.dx, dvy = c.dy - a.dy;
  const double terms[] = {ux.value * dvy, dux * vy.value, -uy.value * dvx, -duy * vx.value};
  const double added = (terms[0] + terms[1]) + (terms[2] + terms[3]);
  const double added_size = (std::fabs(terms[0]) + std::fabs(terms[1])) + (std::fabs(terms[2]) + std::fabs(terms[3]));
  // Each part rounds a few times; then the part of second order; and what underflow takes from any of them.
  const double error =
      0x1p-49 * (given_size + added_size) + 2 * (std::fabs(dux * dvy) + std::fabs(duy * dvx)) + 0x1p-900;
  const double all = given + added;
  return all > error ? 1 : -all > error ? -1 : 0;
}

}  // namespace

int orientation_in_doubles(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c, double room) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double det = left - right;
  // Shewchuk's bound (3 + 16u) u for the rounding, doubled for underflow; the absolute term covers the displacement of
  // coordinates up to 1, which adds less than 2^5 of the room.
  const double error = 0x1p-50 * (std::fabs(left) + std::fabs(right)) + 0x1p10 * room;
  return det > error ? 1 : -det > error ? -1 : 0;
}

StagedSign orientation_staged(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c, double room) {
  if (const int sign = orientation_in_doubles(a, b, c, room)) return {sign, Stage::doubles};
  if (const int sign = orientation_nearly_in_line(a, b, c)) return {sign, Stage::exact};
  // Exactly: F0 + F1 + F2, where F1 and F2 are far smaller unless F0 is zero - but "far" is not a proof, so all
  // three levels go into one sum.
  ExactSum<48> sum;
  add_level(sum, a, b, c, 0, 0);
  add_level(sum, a, b, c, 1, 1);
  add_level(sum, a, b, c, 0, 1);
  add_level(sum, a, b, c, 1, 0);
  return {sum.sign(), Stage::exact};
}

int orientation(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c, double room) {
  return orientation_staged(a, b, c, room).sign;
}

}  // namespace taut::internal
