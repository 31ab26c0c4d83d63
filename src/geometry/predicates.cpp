#include "geometry/predicates.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numeric/exact_sum.hpp"

namespace taut::internal {

int orientation_exact(const Point& a, const Point& b, const Point& c) {
  ExactSum<12> sum;  // six products of two components each
  sum.add_product(a.x, b.y);
  sum.subtract_product(a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.subtract_product(b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.subtract_product(c.y, a.x);
  return sum.sign();
}

int cross_sign_exact(const Point& a, const Point& b, const Point& c, const Point& d) {
  ExactSum<16> sum;  // eight products of two components each
  sum.add_product(b.x, d.y);
  sum.subtract_product(b.x, c.y);
  sum.subtract_product(a.x, d.y);
  sum.add_product(a.x, c.y);
  sum.subtract_product(b.y, d.x);
  sum.add_product(b.y, c.x);
  sum.add_product(a.y, d.x);
  sum.subtract_product(a.y, c.x);
  return sum.sign();
}

int side_of_ring(const Polygon& ring, const Point& p) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (p.y < std::min(a.y, b.y) || p.y > std::max(a.y, b.y)) continue;
    const int side = orientation(a, b, p);
    if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)) return 0;
    // A ray to one side crosses the ring an odd number of times from inside.
    if ((a.y > p.y) != (b.y > p.y) && (side > 0) == (a.y < b.y)) odd = !odd;
  }
  return odd ? 1 : -1;
}

namespace {

double distance_squared(const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return dx * dx + dy * dy;
}

/// Of so few points, all pairs cost less than their hull.
constexpr std::size_t few_points = 16;

double diameter_squared_of_all(const std::vector<Point>& points) {
  double best = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) best = std::max(best, distance_squared(points[i], points[k]));
  }
  return best;
}

/// Appends `next` to a chain whose turns are to stay strictly left; the first `fixed` indices are never dropped.
void extend_chain(const std::vector<Point>& points, std::size_t fixed, int next, std::vector<int>& chain) {
  while (chain.size() > fixed &&
         orientation(points[chain[chain.size() - 2]], points[chain[chain.size() - 1]], points[next]) <= 0)
    chain.pop_back();
  chain.push_back(next);
}

}  // namespace

std::vector<int> convex_hull(const std::vector<Point>& points) {
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    if (points[a] != points[b]) return lexicographically_less(points[a], points[b]);
    return a < b;
  });
  order.erase(std::unique(order.begin(), order.end(), [&](int a, int b) { return points[a] == points[b]; }),
              order.end());
  if (order.size() < 2) return order;

  std::vector<int> hull;
  hull.reserve(order.size() + 1);
  for (const int i : order) extend_chain(points, 1, i, hull);  // lower chain, from left to right
  const std::size_t lower = hull.size();
  for (std::size_t k = order.size() - 1; k-- > 0;) extend_chain(points, lower, order[k], hull);  // upper, back again
  hull.pop_back();                                                                               // the first one again
  return hull;
}

int polygon_orientation(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return 0;
  std::size_t first = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (lexicographically_less(polygon[i], polygon[first])) first = i;
  // An extreme point: its two edges lead to larger points, and were they collinear, they would overlap.
  return orientation(polygon[(first + n - 1) % n], polygon[first], polygon[(first + 1) % n]);
}

double diameter_squared(const std::vector<Point>& points) {
  if (points.size() <= few_points) return diameter_squared_of_all(points);
  const std::vector<int> hull = convex_hull(points);
  const std::size_t n = hull.size();
  if (n < 2) return 0;
  const auto at = [&](std::size_t i) -> const Point& { return points[hull[i % n]]; };
  if (n == 2) return distance_squared(at(0), at(1));

  double best = 0;
  std::size_t far = 1;
  for (std::size_t i = 0; i < n; ++i) {
    best = std::max(best, distance_squared(at(i + 1), at(far)));
    // Walk while the next vertex is further from edge i; every vertex on the way is antipodal to its start.
    while (cross_sign(at(i), at(i + 1), at(far), at(far + 1)) > 0) {
      far = (far + 1) % n;
      best = std::max({best, distance_squared(at(i), at(far)), distance_squared(at(i + 1), at(far))});
    }
    // Parallel edges: the far end of the opposite edge is antipodal too.
    if (cross_sign(at(i), at(i + 1), at(far), at(far + 1)) == 0)
      best = std::max({best, distance_squared(at(i), at(far + 1)), distance_squared(at(i + 1), at(far + 1))});
    best = std::max(best, distance_squared(at(i), at(far)));
  }
  return best;
}

}  // namespace taut::internal
