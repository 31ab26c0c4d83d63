#include "support/exact_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace taut::testing {
namespace {

constexpr int finest_bit = 700;

Integer cross(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int sign(const Integer& x) { return x.sign(); }

bool on_segment(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p) {
  return sign(cross(a, b, p)) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool segments_meet(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d) {
  if (sign(cross(a, b, c)) * sign(cross(a, b, d)) < 0 && sign(cross(c, d, a)) * sign(cross(c, d, b)) < 0) return true;
  return on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
}

/// An edge with its rectangle, sorted by its left end.
struct Edge {
  const ExactPoint *from, *to;
  std::size_t ring, index;
  const Integer &left, &right, &low, &high;

  Edge(const std::vector<ExactPoint>& r, std::size_t number, std::size_t i)
      : from(&r[i]),
        to(&r[(i + 1) % r.size()]),
        ring(number),
        index(i),
        left(std::min(from->x, to->x)),
        right(std::max(from->x, to->x)),
        low(std::min(from->y, to->y)),
        high(std::max(from->y, to->y)) {}
};

/// Calls `meet(e, f)` for pairs of edges whose rectangles meet, until it is true.
template <class Meet>
bool any_pair(const std::vector<Edge>& edges, const Meet& meet) {
  std::vector<std::size_t> order(edges.size()), open;
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return edges[a].left < edges[b].left; });
  for (const std::size_t i : order) {
    const Edge& e = edges[i];
    open.erase(std::remove_if(open.begin(), open.end(), [&](std::size_t k) { return edges[k].right < e.left; }),
               open.end());
    for (const std::size_t k : open) {
      const Edge& f = edges[k];
      if (e.low <= f.high && f.low <= e.high && meet(f, e)) return true;
    }
    open.push_back(i);
  }
  return false;
}

}  // namespace

Integer exact_integer(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int shift = exponent - 53 + finest_bit;
  if (x != 0 && shift < 0) throw std::range_error("a number that is no multiple of 2^-700");
  return x == 0 ? Integer(0) : Integer(mantissa) << static_cast<unsigned>(shift);
}

ExactPoint moved_point(const DisplacedPoint& v) {
  return {exact_integer(v.x) + exact_integer(v.dx), exact_integer(v.y) + exact_integer(v.dy)};
}

ExactPoint original_point(const DisplacedPoint& v) { return {exact_integer(v.x), exact_integer(v.y)}; }

bool corner_keeps_law(const Point& u, const DisplacedPoint& v, const Point& w, Offset offset, double delta) {
  const ExactPoint a = original_point({u.x, u.y, 0, 0}), b = original_point(v), c = original_point({w.x, w.y, 0, 0});
  const Integer dx = exact_integer(v.dx), dy = exact_integer(v.dy), unit = exact_integer(delta);
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c)}) {
    const Integer ex = to.x - from.x, ey = to.y - from.y,
                  side = (ex * dy - ey * dx) * (offset == Offset::inward ? 1 : -1);
    const Integer square = side * side, least = unit * unit * (ex * ex + ey * ey);
    if (sign(side) <= 0 || square < least || square > 4 * least) return false;
  }
  return true;
}

bool rings_meet(const std::vector<ExactPoint>& a, const std::vector<ExactPoint>& b) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < a.size(); ++i) edges.emplace_back(a, 0, i);
  for (std::size_t i = 0; i < b.size(); ++i) edges.emplace_back(b, 1, i);
  return any_pair(edges, [](const Edge& e, const Edge& f) {
    return e.ring != f.ring && segments_meet(*e.from, *e.to, *f.from, *f.to);
  });
}

bool ring_meets_itself(const std::vector<ExactPoint>& ring) {
  std::vector<Edge> edges;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) edges.emplace_back(ring, 0, i);
  return any_pair(edges, [n](const Edge& e, const Edge& f) {
    if ((e.index + 1) % n == f.index) return on_segment(*e.from, *e.to, *f.to) || on_segment(*f.from, *f.to, *e.from);
    if ((f.index + 1) % n == e.index) return on_segment(*f.from, *f.to, *e.to) || on_segment(*e.from, *e.to, *f.from);
    return segments_meet(*e.from, *e.to, *f.from, *f.to);
  });
}

Integer twice_area(const std::vector<ExactPoint>& ring) {
  Integer sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

bool ring_contains(const std::vector<ExactPoint>& ring, const ExactPoint& p) {
  int winding = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ExactPoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (a.y <= p.y && b.y > p.y && sign(cross(a, b, p)) > 0) ++winding;
    if (a.y > p.y && b.y <= p.y && sign(cross(a, b, p)) < 0) --winding;
  }
  return winding != 0;
}

const char* broken_law(const std::vector<Point>& polygon, const DisplacedPolygon& displaced, Offset offset) {
  const std::size_t n = polygon.size();
  std::vector<ExactPoint> before, after;
  for (const DisplacedPoint& v : displaced.points) {
    before.push_back(original_point(v));
    after.push_back(moved_point(v));
    if (std::max(std::fabs(v.dx), std::fabs(v.dy)) > displacement_limit) return "a vertex moves too far";
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!corner_keeps_law(polygon[(i + n - 1) % n], displaced.points[i], polygon[(i + 1) % n], offset,
                          displacement_unit)) {
      return "an edge does not move by between delta and 2 delta";
    }
  }
  if (ring_meets_itself(after)) return "the displaced ring is not simple";
  if (sign(twice_area(after)) <= 0) return "the displaced ring runs clockwise";
  if (rings_meet(before, after)) return "the displaced ring meets the polygon's";
  if (offset == Offset::inward ? !ring_contains(before, after[0]) : !ring_contains(after, before[0])) {
    return "the displaced ring lies on the wrong side";
  }
  return "";
}

}  // namespace taut::testing
