#include <cmath>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::gen {

namespace {

constexpr double tooth_half_width = 0.2;  ///< of a tooth; teeth stand at distance 1, so the play is 0.1 to either side
constexpr double tooth_height = 4;

/// Teeth upwards from a bar below y = 0, the first one at x = 0.
Polygon comb(int teeth) {
  Polygon polygon{{-0.5, -1}, {teeth - 0.5, -1}};
  for (int i = teeth - 1; i >= 0; --i) {
    polygon.push_back({i + tooth_half_width, 0});
    polygon.push_back({i + tooth_half_width, tooth_height});
    polygon.push_back({i - tooth_half_width, tooth_height});
    polygon.push_back({i - tooth_half_width, 0});
  }
  return polygon;
}

/// The same comb upside down, its teeth in the middle of the first one's slots.
Polygon turned_comb(int teeth) {
  Polygon polygon = comb(teeth);
  for (Point& p : polygon) p = {teeth - 0.5 - p.x, tooth_height + 0.5 - p.y};
  return polygon;
}

}  // namespace

Scene make_combs(const CombOptions& o) {
  require_range("--teeth", o.teeth, 1, 10000000);
  require_range("--swings", o.swings, 1, max_degree);
  const double amplitude = o.hit ? -0.15 : -0.08;
  const double bob = 0.2;
  const int bobs = o.swings > 1 ? o.swings - 1 : 1;
  MotionPiece swing = translation(chebyshev(o.swings, amplitude, 0), chebyshev(bobs, bob, 0));
  swing.until = 1;
  // Every Chebyshev polynomial is 1 at 1: from there straight up.
  const double pull = tooth_height + 2;
  const MotionPiece out = translation({amplitude}, {bob - pull, pull});
  Scene scene;
  // The combs begin near the middle of the play: at the polynomial's first zero, to four decimals.
  scene.start = -std::floor(1e4 * std::cos(pi / (2 * o.swings))) / 1e4;
  scene.end = 2;
  scene.bodies = {{"lower", comb(o.teeth), {}}, {"upper", turned_comb(o.teeth), Motion{{swing, out}}}};
  return scene;
}

}  // namespace taut::gen
