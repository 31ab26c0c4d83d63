#include "geometry/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace taut {
namespace {

/// SplitMix64: the same numbers on every platform.
double random_between(std::uint64_t key, double lo, double hi) {
  std::uint64_t z = key + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return lo + (hi - lo) * (static_cast<double>(z >> 11) * 0x1p-53);
}

struct Vector {
  double x, y;
};

Vector unit_towards(const Point& from, const Point& to) {
  // Scale first: a short edge of a small polygon must not underflow when squared.
  double x = to.x - from.x, y = to.y - from.y;
  const double m = std::max(std::fabs(x), std::fabs(y));
  x /= m;
  y /= m;
  const double length = std::sqrt(x * x + y * y);
  return {x / length, y / length};
}

}  // namespace

DisplacedPolygon::DisplacedPolygon(std::vector<DisplacedPoint> vertices, bool fine)
    : points(std::move(vertices)), fine_features(fine) {
  if (points.empty()) return;
  bounds = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (const DisplacedPoint& v : points) {
    bounds.lo = {std::min(bounds.lo.x, v.x), std::min(bounds.lo.y, v.y)};
    bounds.hi = {std::max(bounds.hi.x, v.x), std::max(bounds.hi.y, v.y)};
  }
  largest = std::max(std::max(-bounds.lo.x, bounds.hi.x), std::max(-bounds.lo.y, bounds.hi.y));
}

std::vector<DisplacedPoint> displace(std::span<const Point> polygon, bool inwards, double delta, std::uint64_t seed) {
  const std::size_t n = polygon.size();
  const double side = inwards ? 1.0 : -1.0;
  std::vector<DisplacedPoint> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point& v = polygon[i];
    const Vector in = unit_towards(polygon[(i + n - 1) % n], v);
    const Vector on = unit_towards(v, polygon[(i + 1) % n]);
    // The inner normals of the two edges; the vertex moves by r1 along the first and r2 along the second.
    const double r1 = side * random_between(seed + 2 * i, 1.05, 1.95);
    const double r2 = side * random_between(seed + 2 * i + 1, 1.05, 1.95);
    const double cross = in.x * on.y - in.y * on.x;
    const double dot = in.x * on.x + in.y * on.y;
    double dx, dy;
    if (std::fabs(cross) > 0.05) {
      // d = alpha in + beta on with n_in . d = r1 and n_on . d = r2, where n_e is e turned by +90 degrees.
      const double alpha = -r2 / cross, beta = r1 / cross;
      dx = alpha * in.x + beta * on.x;
      dy = alpha * in.y + beta * on.y;
    } else if (dot > 0) {
      // Nearly straight: along the mean normal, with a random slide.
      const double slide = random_between(~seed + i, -0.3, 0.3);
      const double r = side * random_between(seed + 2 * i, 1.3, 1.7);
      dx = -r * on.y + slide * on.x;
      dy = r * on.x + slide * on.y;
    } else {
      // A spike: its tip runs back (inwards) or out (outwards) along the bisector, by about r over the half angle.
      const double half = std::max(std::fabs(cross) / 2, 0x1p-40);
      const double run = std::fabs(r1) / half;
      const bool convex = cross > 0;  // a zero angle counts as reflex: it never occurs in a simple polygon
      const double along = (convex == inwards) ? -run : run;
      dx = along * in.x + 0.1 * side * (-in.y) * (r2 - r1);
      dy = along * in.y + 0.1 * side * in.x * (r2 - r1);
    }
    out[i] = {v.x, v.y, delta * dx, delta * dy};
  }
  return out;
}

}  // namespace taut
