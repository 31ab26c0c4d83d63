#include "support/contact_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace taut::testing {
namespace {

const std::vector<Polygon>& shapes() {
  static const std::vector<Polygon> list = {
      {{0, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {2, 0}, {1, 1}},
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
      {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}},
      {{0, 0}, {1, 0}, {2, 0}, {4, 0}, {0, 1}},
      {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
      {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
      {{0, 0}, {2, 1}, {0, 2}, {1, 1}},
      {{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}, {1, 1}},
      {{0, 0}, {4, 0}, {4, 1}, {2, 0.5}, {0, 1}},
  };
  return list;
}

}  // namespace

ShortMap random_map(Rng& rng, bool sharp) {
  ShortMap m;
  if (sharp) {
    m = {double(rng.between(1, 10)), 0, 0, std::ldexp(rng.between(1, 7), -rng.between(4, 22))};
    if (rng.chance(0.4)) m.xy = rng.between(-2, 2);
    if (rng.chance(0.3)) m.yx = m.yy * rng.between(-3, 3);
    if (rng.chance(0.3)) m = {-m.yx, -m.yy, m.xx, m.xy};  // a quarter turn
    if (rng.chance(0.3)) m = {m.xx + m.yx, m.xy + m.yy, m.yx - m.xx, m.yy - m.xy};
    return m;
  }
  do {
    m = {double(rng.between(-2, 2)), double(rng.between(-2, 2)), double(rng.between(-2, 2)),
         double(rng.between(-2, 2))};
    if (rng.chance(0.5)) m = {double(rng.between(1, 3)), 0, 0, double(rng.between(1, 3))};
  } while (m.xx * m.yy == m.xy * m.yx);
  return m;
}

Polygon random_shape(Rng& rng, const ShortMap& map) {
  Polygon shape = rng.pick(shapes());
  const Point origin = rng.pick(shape);
  for (Point& p : shape) p = map({p.x - origin.x, p.y - origin.y});
  if (rng.chance(0.3)) std::reverse(shape.begin(), shape.end());
  std::rotate(shape.begin(), shape.begin() + rng.below(static_cast<int>(shape.size())), shape.end());
  return shape;
}

Point random_place(Rng& rng, const Polygon& polygon) {
  const int n = static_cast<int>(polygon.size()), i = rng.below(n);
  const Point &a = polygon[static_cast<std::size_t>(i)], &b = polygon[static_cast<std::size_t>((i + 1) % n)];
  return rng.chance(0.3) ? Point{(a.x + b.x) / 2, (a.y + b.y) / 2} : a;
}

Point random_way(Rng& rng, const Polygon& p, const Polygon& q) {
  if (rng.chance(0.15)) return {double(rng.between(-2, 2)), double(rng.between(-2, 2))};
  const Polygon& own = rng.below(2) ? p : q;
  const int n = static_cast<int>(own.size()), i = rng.below(n), j = rng.chance(0.7) ? i + 1 : rng.below(n);
  const Point &a = own[static_cast<std::size_t>(i)], &b = own[static_cast<std::size_t>(j % n)];
  const double factor = rng.pick(std::vector<double>{-2, -1, -1, -0.5, 0.5, 1, 1, 2});
  return {factor * (b.x - a.x), factor * (b.y - a.y)};
}

}  // namespace taut::testing
