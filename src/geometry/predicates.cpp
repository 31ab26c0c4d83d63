#include "geometry/predicates.hpp"

#include <algorithm>

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

}  // namespace taut::internal
