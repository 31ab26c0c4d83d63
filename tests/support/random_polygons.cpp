#include "support/random_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "support/int_polygon.hpp"
#include "support/triangulation.hpp"

namespace taut::testing {

namespace {

using IntPair = std::pair<IntPolygon, IntPolygon>;

// ---- two trees of triangles in one triangulation ----

std::vector<IntPoint> random_points(Rng& rng, int count, int range, bool grid) {
  const int steps = static_cast<int>(std::sqrt(count) * 1.3) + 1, step = 2 * range / steps;
  std::set<IntPoint> points;
  while (static_cast<int>(points.size()) < count) {
    if (grid) {
      points.insert(
          {std::int64_t{step} * rng.below(steps + 1) - range, std::int64_t{step} * rng.below(steps + 1) - range});
    } else {
      points.insert({rng.between(-range, range), rng.between(-range, range)});
    }
  }
  return {points.begin(), points.end()};
}

Triangulation random_triangulation(Rng& rng, int count, int range, bool grid) {
  Triangulation t(random_points(rng, count, range, grid));
  t.make_delaunay();
  if (rng.chance(0.6)) t.flip_randomly(rng, rng.below(3 * count));
  return t;
}

/// A simply connected union of triangles with every vertex on its boundary, grown from `start`, vertices unused so far.
std::vector<int> grow(Rng& rng, const Triangulation& t, std::vector<char>& used, const Triangulation::Triangle& start,
                      int size) {
  std::vector<int> ring(start.begin(), start.end());
  for (const int v : ring) used[v] = 1;
  std::vector<std::pair<int, int>> options;
  while (static_cast<int>(ring.size()) < size) {
    options.clear();
    for (int i = 0; i < static_cast<int>(ring.size()); ++i) {
      const int v = t.apex(ring[(i + 1) % static_cast<int>(ring.size())], ring[i]);  // across edge i
      if (v >= 0 && !used[v]) options.emplace_back(i, v);
    }
    if (options.empty()) break;
    const auto [i, v] = rng.pick(options);
    ring.insert(ring.begin() + i + 1, v);
    used[v] = 1;
  }
  return ring;
}

IntPolygon polygon_of(const Triangulation& t, const std::vector<int>& ring) {
  IntPolygon p;
  for (const int v : ring) p.push_back(t.points()[v]);
  return p;
}

std::vector<Triangulation::Triangle> unused_triangles(const Triangulation& t, const std::vector<char>& used) {
  std::vector<Triangulation::Triangle> free;
  for (const auto& tri : t.triangles())
    if (!used[tri[0]] && !used[tri[1]] && !used[tri[2]]) free.push_back(tri);
  return free;
}

constexpr int grown_range = 10000;

std::optional<IntPair> intertwined(Rng& rng, bool grid) {
  const int count = rng.between(12, 90);
  const Triangulation t = random_triangulation(rng, count, grown_range, grid);
  if (t.triangles().empty()) return std::nullopt;
  std::vector<char> used(count, 0);
  const auto first = rng.pick(t.triangles());
  for (const int v : first) used[v] = 1;
  const auto others = unused_triangles(t, used);
  if (others.empty()) return std::nullopt;
  const auto second = rng.pick(others);
  for (const int v : second) used[v] = 1;  // reserved while the first one grows
  const auto p = grow(rng, t, used, first, rng.between(3, count / 2));
  const auto q = grow(rng, t, used, second, rng.between(3, count / 2));
  return IntPair{polygon_of(t, p), polygon_of(t, q)};
}

std::optional<IntPair> apart(Rng& rng, bool grid) {
  const auto a = intertwined(rng, grid), b = intertwined(rng, grid);
  if (!a || !b) return std::nullopt;
  const int step = grid ? 1000 : 1;
  const int dx = rng.sign() * rng.between(8 * grown_range / 10, 3 * grown_range) / step * step;
  const int dy = rng.sign() * rng.between(0, 3 * grown_range) / step * step;
  IntPolygon q = b->second;
  for (IntPoint& v : q) v = {v.x + dx, v.y + dy};
  return IntPair{a->first, q};
}

std::int64_t distance_squared(const IntPoint& a, const IntPoint& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// The triangle whose vertices are nearest to a point.
Triangulation::Triangle nearest(const Triangulation& t, const std::vector<Triangulation::Triangle>& triangles,
                                const IntPoint& to) {
  const auto far = [&](const Triangulation::Triangle& tri) {
    std::int64_t d = 0;
    for (const int v : tri) d += distance_squared(t.points()[v], to);
    return d;
  };
  return *std::min_element(triangles.begin(), triangles.end(),
                           [&](const auto& a, const auto& b) { return far(a) < far(b); });
}

std::optional<IntPair> nested(Rng& rng, bool grid) {
  const int count = rng.between(20, 90);
  const Triangulation t = random_triangulation(rng, count, grown_range, grid);
  if (t.triangles().empty()) return std::nullopt;
  std::vector<char> used(count, 0);
  const auto q = grow(rng, t, used, nearest(t, t.triangles(), {0, 0}), rng.between(3, 12));
  const auto others = unused_triangles(t, used);
  if (others.empty()) return std::nullopt;
  const auto p = grow(rng, t, used, nearest(t, others, t.points()[q[0]]), count);
  if (p.size() < 6) return std::nullopt;
  IntPair pair{polygon_of(t, p), polygon_of(t, q)};
  if (rng.chance(0.6)) {  // shrink q about its first vertex so that it can move
    const int f = rng.pick(std::vector<int>{3, 5, 9});
    const IntPoint o = pair.second[0];
    for (IntPoint& v : pair.first) v = {v.x * f, v.y * f};
    for (IntPoint& v : pair.second) v = {o.x * f + v.x - o.x, o.y * f + v.y - o.y};
  }
  return pair;
}

// ---- shapes drawn on purpose ----

IntPoint rounded(double x, double y, int step = 1) {
  return {static_cast<std::int64_t>(std::floor(x / step + 0.5)) * step,
          static_cast<std::int64_t>(std::floor(y / step + 0.5)) * step};
}

/// A block with a winding corridor that ends in a chamber, and a small polygon in the chamber.
std::optional<IntPair> corridor(Rng& rng, bool grid) {
  const int step = grid ? 60 : 1, noise = grid ? 0 : 9, bends = rng.between(1, 5);
  const auto j = [&] { return noise ? rng.between(-noise, noise) : 0; };
  const int w = rng.between(60, 260), stride = rng.between(300, 1500);
  std::vector<IntPoint> middle{{0, 0}};
  for (int i = 0; i < bends; ++i)
    middle.push_back({middle.back().x + stride + rng.between(-100, 100), rng.sign() * rng.between(100, 1400)});
  const double cx = static_cast<double>(middle.back().x), cy = static_cast<double>(middle.back().y);
  const int radius = rng.between(600, 1500), high = 4000;
  const double right = cx + 3 * radius + 500, mx = cx + 1.1 * radius;
  const auto at = [&](double x, double y) { return rounded(x + j(), y + j(), step); };

  IntPolygon p{at(0, -high), at(right, -high), at(right, high), at(0, high)};
  for (const IntPoint& c : middle) p.push_back(at(double(c.x), double(c.y + w)));
  const int m = rng.between(4, 8);
  for (int i = 0; i < m; ++i) {  // the chamber, from the corridor's upper wall clockwise to its lower one
    const Point d = unit_vector(0.375 - 0.75 * i / (m - 1));
    p.push_back(at(mx + radius * d.x, cy + radius * d.y));
  }
  for (std::size_t i = middle.size(); i-- > 0;) p.push_back(at(double(middle[i].x), double(middle[i].y - w)));

  IntPolygon q;
  const int n = rng.between(3, 8), size = rng.pick(std::vector<int>{40, 80, 150, 300});
  const double phase = rng.unit();
  for (int i = 0; i < n; ++i) {
    const Point d = unit_vector(phase + double(i) / n);
    const double r = size * rng.real(0.4, 1);
    q.push_back(rounded(mx + r * d.x, cy + r * d.y, grid ? 20 : 1));
  }
  return IntPair{p, q};
}

IntPolygon comb(Rng& rng, int teeth, double half_width, double height, double base, double scale, int noise, int step) {
  const auto at = [&](double x, double y) {
    const IntPoint p = rounded(scale * x, scale * y, step);
    return noise ? IntPoint{p.x + rng.between(-noise, noise), p.y + rng.between(-noise, noise)} : p;
  };
  IntPolygon p{at(-0.5, -base), at(teeth - 0.5, -base)};
  for (int i = teeth - 1; i >= 0; --i) {
    p.push_back(at(i + half_width, 0));
    p.push_back(at(i + half_width, height));
    p.push_back(at(i - half_width, height));
    p.push_back(at(i - half_width, 0));
  }
  return p;
}

std::optional<IntPair> combs(Rng& rng, bool grid) {
  const int teeth = rng.between(1, 9), scale = 2000, step = grid ? 100 : 1,
            noise = grid ? 0 : rng.pick(std::vector<int>{1, 40});
  const double half = rng.real(0.1, 0.24), height = rng.real(0.5, 5), base = rng.real(0.2, 1);
  const IntPolygon a = comb(rng, teeth, half, height, base, scale, noise, step);
  IntPolygon b = comb(rng, teeth, half, height, base, scale, noise, step);
  // Upside down, teeth over slots, tips at a random depth: from above all tips to just above the bottom.
  const double tips = height * rng.real(0.05, 1.3);
  const IntPoint o = rounded((teeth - 0.5 + rng.real(-0.1, 0.1)) * scale, (height + tips) * scale, step);
  for (IntPoint& v : b) v = {o.x - v.x, o.y - v.y};
  return IntPair{a, b};
}

/// A bar along an Archimedean spiral, `offset` turns ahead.
IntPolygon spiral_bar(double from, double to, int steps, double pitch, double half_width, double offset, int step) {
  IntPolygon outer, inner;
  for (int i = 0; i <= steps; ++i) {
    const double turns = from + (to - from) * i / steps;
    const Point d = unit_vector(turns + offset);
    const double r = pitch * turns;
    outer.push_back(rounded((r + half_width) * d.x, (r + half_width) * d.y, step));
    inner.push_back(rounded((r - half_width) * d.x, (r - half_width) * d.y, step));
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

std::optional<IntPair> spirals(Rng& rng, bool grid) {
  const double from = rng.real(0.8, 1.3), length = rng.real(0.5, 2), pitch = 4000;
  const int per_turn = rng.between(12, 24), steps = static_cast<int>(length * per_turn) + 2, step = grid ? 100 : 1;
  const double width = pitch * rng.real(0.08, 0.17);
  const IntPolygon p = spiral_bar(from, from + length, steps, pitch, width, 0, step);
  const double begin = from + rng.real(-0.2, 0.4), end = begin + length * rng.real(0.3, 1);
  const IntPolygon q =
      spiral_bar(begin, end, std::max(2, steps - rng.below(4)), pitch, width * rng.real(0.4, 1), 0.5, step);
  return IntPair{p, q};
}

IntPolygon star(Rng& rng, int n, double radius, double inner, const IntPoint& centre, int step) {
  IntPolygon p;
  const double phase = rng.unit();
  for (int i = 0; i < n; ++i) {
    const Point d = unit_vector(phase + (i + rng.real(0, 0.4)) / n);
    const double r = radius * rng.real(inner, 1);
    p.push_back(rounded(double(centre.x) + r * d.x, double(centre.y) + r * d.y, step));
  }
  return p;
}

IntPolygon convex_polygon(Rng& rng, int n, double radius, const IntPoint& centre, int step) {
  IntPolygon points = star(rng, n, radius, 0.7, centre, step), hull;
  std::sort(points.begin(), points.end());
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t fixed = hull.size();
    for (const IntPoint& p : points) {
      while (hull.size() >= fixed + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::optional<IntPair> side_by_side(Rng& rng, bool grid, bool is_convex) {
  const int step = grid ? 1000 : 1;
  const double r = 10000, s = r * rng.pick(std::vector<double>{0.2, 0.6, 1.0});
  const Point d = unit_vector(rng.unit());
  const double distance = (r + s) * rng.pick(std::vector<double>{0.85, 1.02, 1.3, 2});
  const IntPoint o = rounded(distance * d.x, distance * d.y, step);
  const int n = rng.between(3, 40), m = rng.between(3, 40);
  if (is_convex) return IntPair{convex_polygon(rng, n, r, {0, 0}, step), convex_polygon(rng, m, s, o, step)};
  const double inner = rng.pick(std::vector<double>{0.3, 0.6, 0.9});
  return IntPair{star(rng, n, r, inner, {0, 0}, step), star(rng, m, s, inner, o, step)};
}

std::optional<IntPair> attempt(Rng& rng, Family family, bool grid) {
  switch (family) {
    case Family::apart:
      return apart(rng, grid);
    case Family::intertwined:
      return intertwined(rng, grid);
    case Family::nested:
      return nested(rng, grid);
    case Family::corridor:
      return corridor(rng, grid);
    case Family::combs:
      return combs(rng, grid);
    case Family::spirals:
      return spirals(rng, grid);
    case Family::stars:
      return side_by_side(rng, grid, false);
    case Family::convex:
      break;
  }
  return side_by_side(rng, grid, true);
}

Polygon to_polygon(IntPolygon p, Rng& rng) {
  std::rotate(p.begin(), p.begin() + rng.below(static_cast<int>(p.size())), p.end());
  Polygon result;
  for (const IntPoint& v : p) result.push_back({static_cast<double>(v.x), static_cast<double>(v.y)});
  return result;
}

}  // namespace

const char* to_string(Family family) {
  switch (family) {
    case Family::apart:
      return "apart";
    case Family::intertwined:
      return "intertwined";
    case Family::nested:
      return "nested";
    case Family::corridor:
      return "corridor";
    case Family::combs:
      return "combs";
    case Family::spirals:
      return "spirals";
    case Family::stars:
      return "stars";
    case Family::convex:
      break;
  }
  return "convex";
}

Point unit_vector(double turns) {
  turns -= std::floor(turns);
  const int quarter = static_cast<int>(turns * 4 + 0.5);  // nearest quarter turn
  const double x = (turns - quarter * 0.25) * 6.283185307179586476925;
  double c = 0, s = 0;
  for (int k = 12; k > 0; --k) {  // Horner on both series at once
    c = (1 + c) * (-x * x / ((2 * k - 1) * (2 * k)));
    s = (1 + s) * (-x * x / ((2 * k) * (2 * k + 1)));
  }
  c += 1;
  s = (1 + s) * x;
  switch (quarter % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

PolygonPair random_pair(Rng& rng, Family family, bool grid) {
  for (;;) {
    std::optional<IntPair> pair = attempt(rng, family, grid);
    if (!pair || !is_simple(pair->first) || !is_simple(pair->second)) continue;
    for (IntPolygon* p : {&pair->first, &pair->second})
      if (area2(*p) < 0) std::reverse(p->begin(), p->end());
    if (!are_disjoint(pair->first, pair->second)) continue;
    return {to_polygon(pair->first, rng), to_polygon(pair->second, rng)};
  }
}

}  // namespace taut::testing
