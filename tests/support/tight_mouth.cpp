#include "support/tight_mouth.hpp"

#include <cmath>

#include "support/random_polygons.hpp"

namespace taut::testing {
namespace {

constexpr double whole_turn = 6.283185307179586;

/// Part of a circle: `count` points from angle `from`, in radians, the last one short of `to`.
void add_arc(Polygon& polygon, const Point& centre, double radius, double from, double to, int count) {
  for (int i = 0; i < count; ++i) {
    const double at = from + (to - from) * i / count;
    polygon.push_back({centre.x + radius * std::cos(at), centre.y + radius * std::sin(at)});
  }
}

}  // namespace

Scene tight_mouth(const MouthOptions& o) {
  const double lip = std::asin((o.gap / 2 + 1) / 9), half = whole_turn / 2;
  constexpr int wall_points = 48;
  Polygon ring, inside;
  add_arc(ring, {0, 0}, 10, lip, whole_turn - lip, wall_points);
  add_arc(ring, {9 * std::cos(lip), -9 * std::sin(lip)}, 1, -lip, half - lip, o.lip_points);
  add_arc(ring, {0, 0}, 8, whole_turn - lip, lip, wall_points);
  add_arc(ring, {9 * std::cos(lip), 9 * std::sin(lip)}, 1, half + lip, whole_turn + lip, o.lip_points);
  add_arc(inside, {o.x, o.y}, o.radius, 0, whole_turn, o.lip_points);
  MotionPiece slow;
  slow.x = {0, 0.001};
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"ring", ring, {}}, {"inside", inside, Motion{{slow}}}};
  return scene;
}

}  // namespace taut::testing
