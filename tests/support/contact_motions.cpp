#include "support/contact_motions.hpp"

#include <algorithm>

namespace taut::testing {
namespace {

constexpr int quarter_cosines[] = {1, 0, -1, 0}, quarter_sines[] = {0, 1, 0, -1};

Coefficients times(double factor, Coefficients c) {
  for (double& x : c) x *= factor;
  return c;
}

/// (a, b), turned by quarters.
DirectionRotation turned(const Coefficients& a, const Coefficients& b, int quarters) {
  const double c = quarter_cosines[quarters], s = quarter_sines[quarters];
  return {sum(times(c, a), times(-s, b)), sum(times(s, a), times(c, b))};
}

}  // namespace

Coefficients power(double factor, double at, int power) {
  Coefficients c{factor};
  for (int k = 0; k < power; ++k) {
    c.push_back(0);
    for (std::size_t i = c.size(); i-- > 0;) c[i] = (i > 0 ? c[i - 1] : 0) - at * c[i];
  }
  return c;
}

Coefficients sum(const Coefficients& a, const Coefficients& b) {
  Coefficients c(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = (k < a.size() ? a[k] : 0) + (k < b.size() ? b[k] : 0);
  return c;
}

Rotation quarter_turn(Rng& rng, int from, bool clockwise, double at) {
  const double side = clockwise ? -1 : 1;
  const Coefficients tau = power(side, at, 1);
  switch (rng.below(5)) {
    case 0:
      if (from == 0) return AngleRotation{times(1.5, tau)};
      break;
    case 1:
      if (from == 0) return HalfAngleRotation{tau};
      if (from == 3 && !clockwise) return HalfAngleRotation{power(1, at + 1, 1)};
      if (from == 1 && clockwise) return HalfAngleRotation{power(-1, at + 1, 1)};
      break;
    case 2: {
      const int order = rng.between(1, 2);  // 2: a bounded speed where the cosine is 1
      if (from == 0 && !clockwise) return CosineRotation{sum({1}, power(-1, at, order))};
      if (from == 1 && !clockwise) return CosineRotation{power(-1, at, order)};
      if (from == 1 && clockwise) return CosineRotation{power(1, at, order)};
      if (from == 2 && clockwise) return CosineRotation{sum({-1}, power(1, at, order))};
      break;
    }
    case 3:  // (1 - tau^2, 2 tau): the square of its length is a square
      return turned(sum({1}, power(-1, at, 2)), times(2, tau), from);
    default:
      break;
  }
  return turned(sum({1}, power(-1, at, 1)), tau, from);
}

Rotation held(Rng& rng, int quarters) {
  if (quarters == 0 && rng.chance(0.5)) return NoRotation{};
  if (quarters == 1 && rng.chance(0.3)) return HalfAngleRotation{{1}};
  if (quarters == 1 && rng.chance(0.3)) return CosineRotation{{0}};
  return turned({1}, {}, quarters);
}

Rotation flat_turn(Rng& rng, double factor, double at, int order) {
  const Coefficients angle = power(factor, at, order);
  // A cosine that reaches 1 on its way bends the motion there, as 1 - angle^2 / 2 does.
  switch (rng.below(at == 0 ? 5 : 20)) {
    case 0:
      return CosineRotation{sum({1}, power(-std::min(factor * factor / 2, 0x1p-7), at, 2 * std::min(order, 2)))};
    case 1:
    case 2:
    case 3:
    case 4:
      return AngleRotation{angle};
    default:
      if (rng.chance(0.5)) return HalfAngleRotation{times(0.5, angle)};
      return DirectionRotation{{1}, angle};
  }
}

}  // namespace taut::testing
