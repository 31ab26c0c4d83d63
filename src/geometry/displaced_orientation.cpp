#include "geometry/displaced_orientation.hpp"

#include <cmath>

#include "numeric/exact_sum.hpp"

namespace taut {
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

}  // namespace taut
