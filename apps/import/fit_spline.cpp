#include "import/fit_spline.hpp"

#include <cmath>
#include <utility>

namespace taut::drawing {

namespace {

Point sum_of(const Point& p, double factor, const Point& q) { return {p.x + factor * q.x, p.y + factor * q.y}; }
Point scaled_by(double factor, const Point& p) { return {factor * p.x, factor * p.y}; }

/// Equations lower[i] d[i-1] + middle[i] d[i] + upper[i] d[i+1] = right[i] for the derivatives d. In each of them the
/// middle exceeds the sum of the others, so that elimination without pivots is stable.
struct Tridiagonal {
  explicit Tridiagonal(std::size_t n) : lower(n), middle(n), upper(n), right(n) {}
  void set(std::size_t i, double below, double at, double above, const Point& value) {
    lower[i] = below;
    middle[i] = at;
    upper[i] = above;
    right[i] = value;
  }

  /// For a row that reaches around from one end to the other, see solve_around().
  std::vector<Point> solve() const {
    const std::size_t n = middle.size();
    std::vector<double> pivot = middle;
    std::vector<Point> d = right;
    for (std::size_t i = 1; i < n; ++i) {
      const double factor = lower[i] / pivot[i - 1];
      pivot[i] -= factor * upper[i - 1];
      d[i] = sum_of(d[i], -factor, d[i - 1]);
    }
    for (std::size_t i = n; i-- > 0;) {
      if (i + 1 < n) d[i] = sum_of(d[i], -upper[i], d[i + 1]);
      d[i] = scaled_by(1 / pivot[i], d[i]);
    }
    return d;
  }

  /// Where lower[0] belongs to the last unknown and the last upper one to the first: by the formula of Sherman and
  /// Morrison.
  std::vector<Point> solve_around() const {
    const std::size_t n = middle.size(), last = n - 1;
    const double corner = -middle[0];
    Tridiagonal open = *this, change = *this;
    open.middle[0] -= corner;
    open.middle[last] -= lower[0] * upper[last] / corner;
    change.middle = open.middle;
    change.right.assign(n, {});
    change.right[0].x = corner;
    change.right[last].x = upper[last];
    std::vector<Point> d = open.solve();
    const std::vector<Point> z = change.solve();
    const double beside = lower[0] / corner, below = 1 + z[0].x + beside * z[last].x;
    const Point factor = scaled_by(1 / below, sum_of(d[0], beside, d[last]));
    for (std::size_t i = 0; i < n; ++i) d[i] = sum_of(d[i], -z[i].x, factor);
    return d;
  }

  std::vector<double> lower, middle, upper;
  std::vector<Point> right;
};

/// The derivatives at all points.
std::vector<Point> slopes_at(const FitPoints& fit, const std::vector<double>& step, const std::vector<Point>& chord) {
  const std::size_t spans = step.size(), n = fit.closed ? spans : spans + 1;
  Tridiagonal system(n);
  const auto inner = [&](std::size_t i, std::size_t before) {
    system.set(i, step[i], 2 * (step[before] + step[i]), step[before],
               scaled_by(3, sum_of(scaled_by(step[i], chord[before]), step[before], chord[i])));
  };
  for (std::size_t i = 1; i < spans; ++i) inner(i, i - 1);
  if (fit.closed) {
    inner(0, spans - 1);
    return system.solve_around();
  }
  const auto end = [&](std::size_t i, const std::optional<Point>& tangent, std::size_t span) {
    if (!tangent) return system.set(i, i == 0 ? 0 : 1, 2, i == 0 ? 1 : 0, scaled_by(3, chord[span]));
    system.set(i, 0, 1, 0, scaled_by(1 / std::hypot(tangent->x, tangent->y), *tangent));
  };
  end(0, fit.start_tangent, 0);
  end(spans, fit.end_tangent, spans - 1);
  return system.solve();
}

}  // namespace

std::vector<std::array<Point, 4>> fit_spline(const FitPoints& given) {
  FitPoints fit = given;
  fit.points.clear();
  for (const Point& p : given.points)
    if (fit.points.empty() || !(p == fit.points.back())) fit.points.push_back(p);
  if (fit.closed && fit.points.size() > 1 && fit.points.front() == fit.points.back()) fit.points.pop_back();
  // Between two points there and back is the same line.
  if (fit.points.size() < 3) fit.closed = false;
  if (fit.points.size() < 2) return {};
  const std::size_t n = fit.points.size(), spans = fit.closed ? n : n - 1;
  std::vector<double> step;
  std::vector<Point> chord;
  for (std::size_t i = 0; i < spans; ++i) {
    const Point along = sum_of(fit.points[(i + 1) % n], -1, fit.points[i]);
    step.push_back(std::hypot(along.x, along.y));
    chord.push_back(scaled_by(1 / step.back(), along));
  }
  const std::vector<Point> slope = slopes_at(fit, step, chord);
  std::vector<std::array<Point, 4>> curves;
  for (std::size_t i = 0; i < spans; ++i) {
    const std::size_t next = (i + 1) % n;
    curves.push_back({fit.points[i], sum_of(fit.points[i], step[i] / 3, slope[i]),
                      sum_of(fit.points[next], -step[i] / 3, slope[next]), fit.points[next]});
  }
  return curves;
}

}  // namespace taut::drawing
