#include "geometry/shape_facts.hpp"
#include "geometry/hull.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace taut::internal {

ShapeFacts facts_of(const Polygon& polygon) {
  ShapeFacts facts;
  facts.size = static_cast<std::uint32_t>(polygon.size());
  facts.reversed = polygon_orientation(polygon) < 0;
  const auto smallest = std::min_element(polygon.begin(), polygon.end(), [](const Point& a, const Point& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  facts.first = static_cast<std::uint32_t>(smallest - polygon.begin());
  facts.least = INFINITY;
  for (const Point& v : polygon) {
    for (const double c : {std::fabs(v.x), std::fabs(v.y)}) {
      if (c == 0) continue;
      facts.least = std::min(facts.least, c);
      facts.largest = std::max(facts.largest, c);
    }
  }
  facts.bounds = box_around(polygon);
  return facts;
}

std::vector<Point> normalised(const Polygon& polygon, const ShapeFacts& facts, int exponent) {
  std::vector<Point> out(polygon.size());
  // A product with a power of two that is a double is what std::ldexp() returns.
  const bool plain = std::abs(exponent) < 1000;
  const double factor = plain ? std::ldexp(1.0, exponent) : 1;
  const auto scaled = [&](double x) { return plain ? x * factor : std::ldexp(x, exponent); };
  for (std::uint32_t k = 0; k < facts.size; ++k) {
    const Point& v = polygon[facts.vertex(k)];
    out[k] = {scaled(v.x), scaled(v.y)};
  }
  return out;
}

}  // namespace taut::internal
