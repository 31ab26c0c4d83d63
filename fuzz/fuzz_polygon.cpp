// A polygon is valid if and only if every pair of its edges says so, in exact integers.
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>

#include "bytes.hpp"
#include "geometry/predicates.hpp"
#include "require.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

using namespace taut;
using namespace taut::internal;

namespace {

using Int = boost::multiprecision::cpp_int;

struct IntPoint {
  Int x, y;
  bool operator==(const IntPoint& o) const { return x == o.x && y == o.y; }
};

/// Coordinates of the contract are multiples of 2^-453.
Int integer(double x) {
  int exponent;
  const double mantissa = std::frexp(x, &exponent);
  return x == 0 ? Int(0) : Int(static_cast<long long>(std::ldexp(mantissa, 53))) << (exponent - 53 + 460);
}

Int cross(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool on_segment(const IntPoint& a, const IntPoint& b, const IntPoint& p) {
  return cross(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool meet(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d) {
  if (on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b)) return true;
  return (cross(a, b, c) > 0) != (cross(a, b, d) > 0) && (cross(c, d, a) > 0) != (cross(c, d, b) > 0);
}

bool is_simple(const std::vector<IntPoint>& p) {
  const std::size_t n = p.size();
  if (n < 3) return false;
  const auto at = [&](std::size_t i) -> const IntPoint& { return p[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (at(i) == at(i + 1)) return false;
    if (on_segment(at(i), at(i + 1), at(i + 2)) || on_segment(at(i + 1), at(i + 2), at(i))) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (!(i == 0 && j == n - 1) && meet(at(i), at(i + 1), at(j), at(j + 1))) return false;
    }
  }
  return true;
}

bool in_contract(double x) { return x == 0 || (std::fabs(x) >= min_coordinate && std::fabs(x) <= max_coordinate); }

bool expected(const Polygon& polygon) {
  std::vector<IntPoint> p;
  for (const Point& v : polygon) {
    if (!in_contract(v.x) || !in_contract(v.y)) return false;
    p.push_back({integer(v.x), integer(v.y)});
  }
  return is_simple(p);
}

bool valid(const Polygon& polygon) {
  try {
    validate_polygon(polygon, "P");
    return true;
  } catch (const InputError& error) {
    fuzz::require(!error.problem().empty() && !error.hint().empty(), "an error that says nothing");
    return false;
  }
}

/// Small integers, so that degeneracies abound; nudged integers; numbers far from 1; any bits.
double coordinate(fuzz::Bytes& bytes, int style, const Polygon& earlier) {
  const double small = bytes.below(32) - 16;
  switch (style == 4 ? bytes.below(4) : style) {
    case 0:
      return small;
    case 1:
      return std::nextafter(small, bytes.below(3) - 1.0);
    case 2:
      return std::ldexp(small, (bytes.u8() - 128) * 3);
    default:
      if (!earlier.empty() && bytes.below(2)) return earlier[bytes.u8() % earlier.size()].x;
      return bytes.f64();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const int style = bytes.below(5);
  Polygon polygon;
  while (!bytes.empty() && polygon.size() < 40) {
    const double x = coordinate(bytes, style, polygon);
    polygon.push_back({x, coordinate(bytes, style, polygon)});
  }
  const bool want = expected(polygon);
  fuzz::require(valid(polygon) == want, want ? "a simple polygon is refused" : "a polygon that is not simple passes");
  if (polygon.empty()) return 0;
  std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  fuzz::require(valid(polygon) == want, "the first vertex matters");
  std::reverse(polygon.begin(), polygon.end());
  fuzz::require(valid(polygon) == want, "the orientation matters");
  for (Point& v : polygon) std::swap(v.x, v.y);
  fuzz::require(valid(polygon) == want, "the mirror image differs");
  return 0;
}
