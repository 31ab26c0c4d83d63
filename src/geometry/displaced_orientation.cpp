#include "geometry/displaced_orientation.hpp"

#include <cmath>

#include "numeric/exact_sum.hpp"

namespace taut::internal {
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
