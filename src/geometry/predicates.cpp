#include "geometry/predicates.hpp"

#include "numeric/exact_sum.hpp"

namespace taut {

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

}  // namespace taut
