#include <cmath>

#include "gen/generators.hpp"
#include "gen/shapes.hpp"

namespace taut::gen {

namespace {

constexpr double radius = 3;  ///< of the rotor's tips
constexpr double valley = 0.8 * radius;
constexpr double gap = 0.02 * radius;
constexpr double chain_radius = 10 * radius;

/// The chain is part of a large circle that passes the rotor at `gap`. The line through its point at angle f has
/// distance |chain_radius - d cos f| from the rotor's centre; of interest are the f for which all teeth cross it and
/// it leaves the valleys alone, above and below the middle.
Polygon chain_holder(int edges) {
  const double d = chain_radius + radius + gap;
  const double from = std::acos((chain_radius + 0.985 * radius) / d);
  const double to = std::acos((chain_radius + 0.94 * radius) / d);
  const int side = std::max(1, edges / 2);
  const double arm = 1.5 * radius, back = -1.9 * radius;
  Polygon polygon{{back, -1.9 * radius}, {arm, -1.9 * radius}, {arm, -1.7 * radius}, {-1.3 * radius, -1.7 * radius}};
  for (int i = -side; i <= side; ++i) {
    if (i == 0) continue;
    const double share = side == 1 ? 1 : (std::abs(i) - 1.0) / (side - 1);
    const double f = (i < 0 ? -1 : 1) * (from + (to - from) * share);
    const Point p = polar(chain_radius, f);
    polygon.push_back({p.x - d, p.y});
  }
  polygon.push_back({-1.3 * radius, 1.7 * radius});
  polygon.push_back({arm, 1.7 * radius});
  polygon.push_back({arm, 1.9 * radius});
  polygon.push_back({back, 1.9 * radius});
  return polygon;
}

Polygon star(int teeth, bool long_tooth) {
  Polygon polygon;
  for (int i = 0; i < teeth; ++i) {
    const double angle = 2 * pi * i / teeth;
    const double tip = long_tooth && i == teeth / 2 + teeth / 4 ? 1.2 * radius : radius;
    polygon.push_back(polar(tip, angle + 0.05 / teeth));
    polygon.push_back(polar(valley, angle + pi / teeth));
  }
  return polygon;
}

}  // namespace

Scene make_rotor(const RotorOptions& o) {
  require_range("--teeth", o.teeth, 3, 10000000);
  require_range("--chain-edges", o.chain_edges, 2, 10000000);
  require_range("--turns", o.turns, 0.001, 1e6);
  MotionPiece turning = translation({}, {});
  turning.rotation = AngleRotation{{0, 2 * pi}};
  Scene scene;
  scene.end = o.turns;
  scene.bodies = {{"holder", chain_holder(o.chain_edges), {}}, {"rotor", star(o.teeth, o.hit), Motion{{turning}}}};
  return scene;
}

}  // namespace taut::gen
