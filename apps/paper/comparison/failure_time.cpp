#include "comparison/failure_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace taut::paper {
namespace {

struct Vector {
  double x = 0, y = 0;
};
Vector minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
double product(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
double length(const Vector& a) { return std::hypot(a.x, a.y); }

/// How fast the difference of two vertices may move within an interval.
struct DifferenceBounds {
  double speed = 0, acceleration = 0;
};
DifferenceBounds difference_bounds(const MovingBodies& bodies, int from, int to, double distance, double t, double h) {
  const int a = bodies.body_of(from), b = bodies.body_of(to);
  const MotionBounds one = bodies.bounds(a, t, h);
  if (a == b) return {one.spin * distance, (one.spin * one.spin + one.spin_change) * distance};
  const MotionBounds other = bodies.bounds(b, t, h);
  const double r = bodies.arm(from, t), s = bodies.arm(to, t);
  return {one.speed + one.spin * r + other.speed + other.spin * s,
          one.acceleration + (one.spin * one.spin + one.spin_change) * r + other.acceleration +
              (other.spin * other.spin + other.spin_change) * s};
}

/// The largest step for which value + slope s - bound s^2 / 2 stays positive.
double safe_step(double value, double slope, double bound) {
  const double root = std::sqrt(slope * slope + 2 * bound * value);
  if (slope > 0) return bound > 0 ? (slope + root) / bound : std::numeric_limits<double>::infinity();
  const double divisor = root - slope;
  return divisor > 0 ? 2 * value / divisor : std::numeric_limits<double>::infinity();
}

}  // namespace

Triple::Triple(int u, int v, int w) : vertices_{u, v, w} {
  const auto order = [this](std::size_t i, std::size_t j) {
    if (vertices_[i] > vertices_[j]) std::swap(vertices_[i], vertices_[j]), parity_ = -parity_;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
}

int Triple::sign(const MovingBodies& bodies, double t) const {
  const double v = parity_ * cross().value(bodies, t);
  return v > 0 ? 1 : v < 0 ? -1 : 0;
}

double Cross::value(const MovingBodies& bodies, double t) const {
  const auto at = [&](int vertex) { return bodies.at(vertex, t).position; };
  return product(minus(at(b), at(a)), minus(at(d), at(c)));
}

double failure_time(const MovingBodies& bodies, const Cross& cross, int sign, double from, double until,
                    std::uint64_t* steps) {
  double t = from, h = until - from, crawl = 0;
  while (true) {
    if (steps) ++*steps;
    const Moving a = bodies.at(cross.a, t), b = bodies.at(cross.b, t),
                 c = cross.c == cross.a ? a : bodies.at(cross.c, t), d = bodies.at(cross.d, t);
    const Vector p = minus(b.position, a.position), q = minus(d.position, c.position);
    const double value = sign * product(p, q);
    if (value < 0) return t;
    if (t >= until) return std::numeric_limits<double>::infinity();
    h = std::min(h, until - t);
    const double slope = sign * (product(minus(b.velocity, a.velocity), q) + product(p, minus(d.velocity, c.velocity)));
    const DifferenceBounds one = difference_bounds(bodies, cross.a, cross.b, length(p), t, h),
                           other = difference_bounds(bodies, cross.c, cross.d, length(q), t, h);
    const double bound = one.acceleration * (length(q) + other.speed * h) + 2 * one.speed * other.speed +
                         (length(p) + one.speed * h) * other.acceleration;
    double step = safe_step(value, slope, bound);
    if (step >= h) {
      t += h;
      h *= 2;
      if (t >= until) return std::numeric_limits<double>::infinity();
      continue;
    }
    const double resolution = 0x1p-50 * std::max(std::fabs(t), 1.0);
    if (step < resolution) {
      crawl = std::max(2 * crawl, resolution);
      step = crawl;
    } else {
      crawl = 0;
    }
    t = std::min(t + step, until);
    h = 4 * step;
  }
}

}  // namespace taut::paper
