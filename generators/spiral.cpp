#include <cmath>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::gen {

namespace {

constexpr double spiral_pitch = 1;  ///< growth of the radius per turn
constexpr double width = 0.16;      ///< of either spiral, measured along the radius
constexpr double inner = 0.6;       ///< smallest radius of the middle line

/// The band around r = inner + spiral_pitch * angle / 2 pi, turned by `phase`.
Polygon band(const SpiralOptions& o, double phase) {
  Polygon inner_side, polygon;
  for (int i = 0; i < o.side_points; ++i) {
    const double angle = 2 * pi * o.turns * i / (o.side_points - 1);
    const double radius = inner + spiral_pitch * angle / (2 * pi);
    inner_side.push_back(polar(radius - width / 2, angle + phase));
    polygon.push_back(polar(radius + width / 2, angle + phase));
  }
  polygon.insert(polygon.end(), inner_side.rbegin(), inner_side.rend());
  return polygon;
}

}  // namespace

Scene make_spiral(const SpiralOptions& o) {
  require_range("--turns", o.turns, 0.1, 10000);
  // Coarser ones would touch: a chord cuts off r (step)^2 / 8.
  require_range("--side-points", o.side_points, 4 + 18 * o.turns * std::sqrt(o.turns), 10000000);
  // Two bands half a pitch apart leave pitch/2 - width on either side. Turning by f moves a band by pitch f / 2 pi.
  const double play = 2 * pi * (spiral_pitch / 2 - width) / spiral_pitch;
  const double share = o.hit ? 1.3 : 0.8;
  // From -play to play within time 1, starting and ending at rest. The band itself is set up screwed in.
  const double angle = (0.8 + share) * play;
  MotionPiece screw = translation({}, {});
  screw.rotation = AngleRotation{{0, 0, 3 * angle, -2 * angle}};
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"groove", band(o, 0), {}}, {"screw", band(o, pi - 0.8 * play), Motion{{screw}}}};
  return scene;
}

}  // namespace taut::gen
