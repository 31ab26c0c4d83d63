#include <algorithm>
#include <cmath>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::gen {

namespace {

constexpr double rotor_radius = 3;  ///< of its tips
constexpr double valley = 0.8 * rotor_radius;
constexpr double gap = 0.02 * rotor_radius;
constexpr double chain_radius = 10 * rotor_radius;

/// The chain is part of a large circle that passes the rotor at `gap`. The line through its point at angle f has
/// distance |chain_radius - d cos f| from the rotor's centre. Wanted are the f, above and below the middle, for which
/// every tip crosses that line and the hull between two tips does not: then the common tangent of the two bodies runs
/// through the whole chain and back for every tooth.
Polygon chain_holder(const RotorOptions& o) {
  const double d = chain_radius + rotor_radius + gap;
  const double bulge = 1 - std::cos(pi / o.teeth);  // of the tips' circle beyond the hull
  const double from = std::acos((chain_radius + (1 - 0.1 * bulge) * rotor_radius) / d);
  const double to = std::acos((chain_radius + (1 - 0.9 * bulge) * rotor_radius) / d);
  const int side = std::max(1, o.chain_edges / 2);
  const double half_height = std::max(1.3 * rotor_radius, chain_radius * std::sin(to));
  Polygon polygon{{-2.5 * rotor_radius, -half_height}};
  for (int i = -side; i <= side; ++i) {
    if (i == 0) continue;
    const double share = side == 1 ? 0 : (std::abs(i) - 1.0) / (side - 1);
    const Point p = polar(chain_radius, (i < 0 ? -1 : 1) * (from + (to - from) * share));
    polygon.push_back({p.x - d, p.y});
  }
  polygon.push_back({-2.5 * rotor_radius, half_height});
  // A notch in the back, so that the holder is the larger body and not convex.
  polygon.push_back({-2.2 * rotor_radius, 0});
  return polygon;
}

Polygon star(int teeth, bool long_tooth) {
  Polygon polygon;
  for (int i = 0; i < teeth; ++i) {
    const double angle = 2 * pi * i / teeth;
    const double tip = long_tooth && i == teeth / 2 + teeth / 4 ? 1.2 * rotor_radius : rotor_radius;
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
  scene.bodies = {{"holder", chain_holder(o), {}}, {"rotor", star(o.teeth, o.hit), Motion{{turning}}}};
  return scene;
}

}  // namespace taut::gen
