#include "families.hpp"

#include <algorithm>
#include <cmath>

#include "coastline.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::bench {
namespace {

// A gear of fewer than 42 teeth has two more vertices at each tooth's foot.
Case gears_of(int teeth_1, int teeth_2) {
  gen::GearOptions o;
  o.teeth_1 = teeth_1;
  o.teeth_2 = teeth_2;
  o.flank_points = teeth_1 < 42 ? 3 : 4;
  return {gen::make_gears(o)};
}

Case gears(int n) { return gears_of(n / 8, n / 8 + 1); }
Case gears_equal(int n) { return gears_of(n / 8, n / 8); }

Case combs(int n) {
  gen::CombOptions o;
  o.teeth = n / 4;
  Scene scene = gen::make_combs(o);
  scene.end = 1;  // before they are pulled out
  return {scene};
}

Case combs_out(int n) {
  Scene scene = resting_combs(n, 1);
  scene.bodies[1].motion = Motion{{gen::translation({0, 0.01}, {0, 6})}};
  return {scene};
}

Case dips(int n) {
  gen::DipOptions o;
  o.sides = n;
  o.dips = 8;
  return {gen::make_dips(o)};
}

Case dips_linear(int n) {
  Case c = dips(n);
  const int pieces = 16;
  const double lowest = 1.15, highest = 6;
  Motion& motion = c.scene.bodies[1].motion;
  motion.pieces.clear();
  c.scene.start = 0;
  c.scene.end = pieces;
  for (int k = 0; k < pieces; ++k) {
    // From `from` at time k to `to` at time k + 1; a little sideways, too.
    const double from = k % 2 == 0 ? highest : lowest, to = highest + lowest - from, speed = to - from;
    MotionPiece piece = gen::translation({-0.05, 0.1 / pieces}, {from - speed * k, speed});
    piece.until = k + 1;
    motion.pieces.push_back(piece);
  }
  return c;
}

/// When `moving`, at a constant velocity, first meets `fixed`, which lies ahead of it: the smallest gap along the
/// velocity between a vertex of the one and an edge of the other.
double first_meeting(const Polygon& fixed, const Polygon& moving, Point velocity) {
  const double speed = std::hypot(velocity.x, velocity.y);
  const Point along{velocity.x / speed, velocity.y / speed};
  const auto turned = [&along](const Polygon& polygon) {
    Polygon out;
    for (const Point& p : polygon) out.push_back({along.x * p.y - along.y * p.x, along.x * p.x + along.y * p.y});
    return out;
  };
  const auto smallest_gap = [](const Polygon& vertices, const Polygon& edges, double side) {
    double gap = INFINITY;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Point a = edges[i], b = edges[(i + 1) % edges.size()];
      const double lo = std::min(a.x, b.x), hi = std::max(a.x, b.x), slope = (b.y - a.y) / (b.x - a.x);
      for (const Point& v : vertices) {
        if (lo <= v.x && v.x <= hi) gap = std::min(gap, side * (a.y + slope * (v.x - a.x) - v.y));
      }
    }
    return gap;
  };
  const Polygon f = turned(fixed), m = turned(moving);
  return std::min(smallest_gap(m, f, 1), smallest_gap(f, m, -1)) / speed;
}

Case far_approach(int n) {
  const Point offset{1000, 37.3}, velocity{-1, -0.037};
  const auto vertices = static_cast<std::size_t>(n);
  Case c;
  c.scene.end = 2000;
  c.scene.bodies = {
      {"rock", island(vertices, 3), {}},
      {"drifter", island(vertices, 4), Motion{{gen::translation({offset.x, velocity.x}, {offset.y, velocity.y})}}}};
  Polygon drifter = c.scene.bodies[1].polygon;
  for (Point& p : drifter) p = {p.x + offset.x, p.y + offset.y};
  c.outcome = Outcome::contact;
  c.contact_time = first_meeting(c.scene.bodies[0].polygon, drifter, velocity);
  return c;
}

/// A wheel with square teeth, narrower than the gaps.
Polygon square_gear(int teeth, double radius, double depth, double share, double phase) {
  Polygon wheel;
  for (int k = 0; k < teeth; ++k) {
    const double pitch = 2 * gen::pi / teeth, from = pitch * (k + phase), to = from + share * pitch;
    for (const auto& [r, angle] : {std::pair{radius, from}, std::pair{radius + depth, from},
                                   std::pair{radius + depth, to}, std::pair{radius, to}})
      wheel.push_back(gen::polar(r, angle));
  }
  return wheel;
}

}  // namespace

Scene square_gears(int n) {
  const int teeth = n / 4;
  const double radius = teeth / (2 * gen::pi), depth = 0.3, share = 0.25;
  Scene scene;
  scene.end = 1;
  const double distance = 2 * radius + depth + 0.1;
  scene.bodies = {
      {"left", square_gear(teeth, radius, depth, share, -share / 2), {}},
      {"right", square_gear(teeth, radius, depth, share, 0.5 - share / 2 + (teeth % 2 == 0 ? 0 : 0.5)), {}}};
  MotionPiece turn;
  turn.rotation = AngleRotation{{0, 2 * gen::pi}};
  scene.bodies[0].motion.pieces = {turn};
  turn.x = {distance};
  turn.rotation = AngleRotation{{0, -2 * gen::pi}};
  scene.bodies[1].motion.pieces = {turn};
  return scene;
}

Scene resting_combs(int n, double end) {
  gen::CombOptions o;
  o.teeth = n / 4;
  Scene scene = gen::make_combs(o);
  scene.start = 0;
  scene.end = end;
  scene.bodies[1].motion = {};
  return scene;
}

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"gears", gears}, {"gears_equal", gears_equal}, {"combs", combs},      {"combs_out", combs_out},
      {"dips", dips},   {"dips_linear", dips_linear}, {"far", far_approach},
  };
  return all;
}

}  // namespace taut::bench
