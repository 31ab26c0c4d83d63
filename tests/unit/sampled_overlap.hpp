// A plain check that shares nothing with the library but the scene: bodies posed in doubles, edges against edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/scene.hpp"

namespace taut::test {

inline double evaluate(const Coefficients& c, double t) {
  double value = 0;
  for (std::size_t i = c.size(); i-- > 0;) value = value * t + c[i];
  return value;
}

inline Point heading(const Rotation& rotation, double t) {
  if (const auto* r = std::get_if<AngleRotation>(&rotation)) {
    return {std::cos(evaluate(r->angle, t)), std::sin(evaluate(r->angle, t))};
  }
  if (const auto* r = std::get_if<DirectionRotation>(&rotation)) {
    const double a = evaluate(r->a, t), b = evaluate(r->b, t), length = std::hypot(a, b);
    return {a / length, b / length};
  }
  if (const auto* r = std::get_if<HalfAngleRotation>(&rotation)) {
    const double s = evaluate(r->s, t);
    return {(1 - s * s) / (1 + s * s), 2 * s / (1 + s * s)};
  }
  if (const auto* r = std::get_if<CosineRotation>(&rotation)) {
    const double a = evaluate(r->a, t);
    return {a, std::sqrt(1 - a * a)};
  }
  return {1, 0};
}

/// The body's polygon at time t.
inline Polygon posed(const Body& body, double t) {
  const auto& pieces = body.motion.pieces;
  if (pieces.empty()) return body.polygon;
  std::size_t k = 0;
  while (k + 1 < pieces.size() && t >= pieces[k].until) ++k;
  const Point x = heading(pieces[k].rotation, t);
  const Point o{evaluate(pieces[k].x, t), evaluate(pieces[k].y, t)};
  Polygon polygon;
  for (const Point& p : body.polygon) {
    polygon.push_back({o.x + p.x * x.x - p.y * x.y, o.y + p.x * x.y + p.y * x.x});
  }
  return polygon;
}

inline double orientation(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline bool contains(const Polygon& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

inline bool edges_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  return orientation(a, b, c) * orientation(a, b, d) <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0;
}

inline bool overlap(const Polygon& p, const Polygon& q) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      if (edges_cross(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()])) return true;
    }
  }
  return contains(p, q[0]) || contains(q, p[0]);
}

/// The first of `count` + 1 equally spaced instants at which the bodies overlap.
inline std::optional<double> first_sampled_overlap(const Scene& scene, int count) {
  for (int i = 0; i <= count; ++i) {
    const double t = scene.start + (scene.end - scene.start) * i / count;
    if (overlap(posed(scene.bodies[0], t), posed(scene.bodies[1], t))) return t;
  }
  return std::nullopt;
}

inline double signed_area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    sum += polygon[j].x * polygon[i].y - polygon[i].x * polygon[j].y;
  }
  return sum / 2;
}

/// No two edges meet but neighbours, and those only in their vertex. Quadratic.
inline bool is_simple(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (polygon[i] == polygon[(i + 1) % n]) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (edges_cross(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) return false;
    }
  }
  return true;
}

}  // namespace taut::test
