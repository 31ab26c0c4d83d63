#include "tiling/separator_curve.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "numeric/budget.hpp"
#include "numeric/real.hpp"

namespace taut::internal {
namespace {

bool finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// The intersection of two lines, rounded once.
Point line_intersection(const DirectedLine& a, const DirectedLine& b) {
  using R = Real320;
  const R ax = R(a.to.x) - R(a.from.x), ay = R(a.to.y) - R(a.from.y);
  const R bx = R(b.to.x) - R(b.from.x), by = R(b.to.y) - R(b.from.y);
  const R cross = ax * by - ay * bx;
  if (cross.is_zero()) return a.to;
  const R share = ((R(b.from.x) - R(a.from.x)) * by - (R(b.from.y) - R(a.from.y)) * bx) / cross;
  return {tidy(RealTraits<R>::to_double(R(a.from.x) + share * ax)),
          tidy(RealTraits<R>::to_double(R(a.from.y) + share * ay))};
}

/// A point on the line from `start` on that lies well outside the bounds, in direction `sign`.
Point far_along(const DirectedLine& line, const Point& start, double sign, const AxisBox& b) {
  const double dx = line.to.x - line.from.x, dy = line.to.y - line.from.y, length = std::sqrt(dx * dx + dy * dy);
  const double size = b.hi_x - b.lo_x + b.hi_y - b.lo_y;
  const Point middle{b.lo_x + (b.hi_x - b.lo_x) / 2, b.lo_y + (b.hi_y - b.lo_y) / 2};
  const double away = std::fabs(start.x - middle.x) + std::fabs(start.y - middle.y);
  // A power of two: the end of a line through two vertices stays exactly on it if their coordinates are short.
  int exponent = 0;
  std::frexp((away + size) / length, &exponent);
  const double step = std::ldexp(sign, exponent);
  return {tidy(start.x + step * dx), tidy(start.y + step * dy)};
}

/// Where two segments cross properly, about.
std::optional<Point> crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (orientation(a, b, c) * orientation(a, b, d) >= 0 || orientation(c, d, a) * orientation(c, d, b) >= 0)
    return std::nullopt;
  return line_intersection({a, b}, {c, d});
}

/// If the ends of an open curve cross, the loop that they close has as many edges.
void close_if_ends_cross(Curve& curve) {
  const std::size_t n = curve.vertices.size();
  if (n < 4) return;
  const auto cross = crossing(curve.vertices[0], curve.vertices[1], curve.vertices[n - 2], curve.vertices[n - 1]);
  if (!cross) return;
  curve.vertices.front() = *cross;
  curve.vertices.pop_back();
  curve.closed = true;
}

// ----- exact checks -----

bool between(const Point& a, const Point& b, const Point& v) {
  return std::min(a.x, b.x) <= v.x && v.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= v.y &&
         v.y <= std::max(a.y, b.y);
}

/// Does the way from vertex v of the polygon towards w begin inside? `before` and `after` are v's neighbours.
bool enters_at_vertex(const Point& before, const Point& v, const Point& after, const Point& w) {
  const bool left_of_in = orientation(before, v, w) > 0, left_of_out = orientation(v, after, w) > 0;
  return orientation(before, v, after) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
}

/// Does the segment meet the open inside?
bool meets_inside(const Point& a, const Point& b, const Polygon& polygon, const AxisBox& bounds) {
  if (std::max(a.x, b.x) < bounds.lo_x || std::min(a.x, b.x) > bounds.hi_x || std::max(a.y, b.y) < bounds.lo_y ||
      std::min(a.y, b.y) > bounds.hi_y)
    return false;
  const std::size_t n = polygon.size();
  bool touches = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &c = polygon[i], &d = polygon[(i + 1) % n];
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
      continue;
    const int at_c = orientation(a, b, c), at_d = orientation(a, b, d);
    if (at_c * at_d > 0) continue;
    const int at_a = orientation(c, d, a), at_b = orientation(c, d, b);
    if (at_a * at_b > 0) continue;
    if (at_c * at_d < 0 && at_a * at_b < 0) return true;
    touches = true;
    if (at_c == 0 && between(a, b, c)) {
      const Point& before = polygon[(i + n - 1) % n];
      if (c != a && enters_at_vertex(before, c, d, a)) return true;
      if (c != b && enters_at_vertex(before, c, d, b)) return true;
    }
    // An end of the segment within the edge.
    if (at_a == 0 && between(c, d, a) && a != c && a != d && at_b > 0) return true;
    if (at_b == 0 && between(c, d, b) && b != c && b != d && at_a > 0) return true;
  }
  return !touches && side_of_ring(polygon, a) > 0;
}

/// A double point strictly inside.
std::optional<Point> point_inside(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  for (double share = 0.5; share > 0x1p-40; share /= 4) {
    for (std::size_t i = 0; i < n; ++i) {
      const Point &u = polygon[i], &v = polygon[(i + 1) % n], &w = polygon[(i + 2) % n];
      checkpoint();
      if (orientation(u, v, w) <= 0) continue;
      const Point middle{u.x + (w.x - u.x) / 2, u.y + (w.y - u.y) / 2};
      const Point p{v.x + share * (middle.x - v.x), v.y + share * (middle.y - v.y)};
      if (side_of_ring(polygon, p) > 0) return p;
    }
  }
  return std::nullopt;
}

/// Beyond `end`, going on from `before`, does the ray stay outside the bounds?
bool leaves_for_good(const Point& before, const Point& end, const AxisBox& b) {
  return (end.x > b.hi_x && end.x >= before.x) || (end.x < b.lo_x && end.x <= before.x) ||
         (end.y > b.hi_y && end.y >= before.y) || (end.y < b.lo_y && end.y <= before.y);
}

}  // namespace

Curve curve_of(const LinkPath& path, const std::vector<Point>& around) {
  Curve curve;
  curve.closed = path.closed;
  const std::size_t n = path.lines.size();
  const AxisBox bounds = box_around(around);
  for (std::size_t i = 0; i + 1 < n; ++i) curve.vertices.push_back(line_intersection(path.lines[i], path.lines[i + 1]));
  if (path.closed) {
    curve.vertices.push_back(line_intersection(path.lines.back(), path.lines.front()));
    return curve;
  }
  const DirectedLine &first = path.lines.front(), &last = path.lines.back();
  const Point start = curve.vertices.empty() ? first.from : curve.vertices.front();
  const Point end = curve.vertices.empty() ? last.to : curve.vertices.back();
  curve.vertices.insert(curve.vertices.begin(), far_along(first, start, -1, bounds));
  curve.vertices.push_back(far_along(last, end, 1, bounds));
  close_if_ends_cross(curve);
  return curve;
}

bool separates(const Curve& curve, const Polygon& p, const Polygon& q) {
  const std::size_t n = curve.vertices.size(), edges = n == 0 ? 0 : curve.edges();
  if (n < 2 || (curve.closed && n < 3) || !std::all_of(curve.vertices.begin(), curve.vertices.end(), finite))
    return false;
  const AxisBox at_p = box_around(p), at_q = box_around(q);
  const auto inside_p = point_inside(p), inside_q = point_inside(q);
  if (!inside_p || !inside_q) return false;
  bool odd = false;
  for (std::size_t i = 0; i < edges; ++i) {
    const Point &a = curve.vertices[i], &b = curve.vertices[(i + 1) % n];
    checkpoint();
    if (a == b) continue;
    if (meets_inside(a, b, p, at_p) || meets_inside(a, b, q, at_q)) return false;
    // The curve avoids both points, so of two sides that differ at most one is zero.
    const bool left_a = orientation(*inside_p, *inside_q, a) > 0, left_b = orientation(*inside_p, *inside_q, b) > 0;
    if (left_a != left_b && orientation(a, b, *inside_p) * orientation(a, b, *inside_q) < 0) odd = !odd;
  }
  if (!curve.closed) {
    for (const AxisBox& b : {at_p, at_q}) {
      if (!leaves_for_good(curve.vertices[1], curve.vertices[0], b)) return false;
      if (!leaves_for_good(curve.vertices[n - 2], curve.vertices[n - 1], b)) return false;
    }
    // The rays must not pass between the two points either.
    AxisBox both = at_p;
    both.include(at_q);
    if (!leaves_for_good(curve.vertices[1], curve.vertices[0], both)) return false;
    if (!leaves_for_good(curve.vertices[n - 2], curve.vertices[n - 1], both)) return false;
  }
  return odd;
}

}  // namespace taut::internal
