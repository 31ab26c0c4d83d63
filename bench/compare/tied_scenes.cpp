#include "compare/tied_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "families.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "taut/check.hpp"

namespace taut::bench {
namespace {

/// By up to a ten millionth in either direction: far more than doubles resolve, and far less than the play.
constexpr double nudge = 1e-7;

Scene combs_apart(int teeth) {
  Scene scene = resting_combs(4 * teeth, 1);
  scene.bodies[1].motion = Motion{{gen::translation({0, 0.01}, {0, 6})}};
  return scene;
}

Scene key_in_lock(int steps) {
  gen::LockOptions options;
  options.steps = steps;
  return gen::make_lock(options);
}

Scene ship_in_maze(int passes) {
  gen::MazeOptions options;
  options.passes = passes;
  return gen::make_maze(options);
}

/// The same octagon twice, so that edges are parallel.
Scene equal_octagons() {
  Polygon octagon;
  for (int k = 0; k < 8; ++k) octagon.push_back(gen::polar(1, gen::pi / 4 * k));
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"first", octagon, {}}, {"second", octagon, Motion{{gen::translation({5, -1}, {0.3})}}}};
  return scene;
}

/// An L flies over a row of blocks, a hundred times their width in one unit of time.
Scene over_blocks(int blocks) {
  Polygon row{{0, 0}, {2.0 * blocks, 0}};
  for (int k = blocks; k-- > 0;) {
    const double height = 1 + k % 3;
    row.push_back({2.0 * k + 2, height});
    row.push_back({2.0 * k, height});
  }
  const Polygon ell{{0, 0}, {3, 0}, {3, 2}, {1, 2}, {1, 4}, {0, 4}};
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"blocks", row, {}}, {"ell", ell, Motion{{gen::translation({-6, 100}, {4})}}}};
  return scene;
}

Point turned(Point p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// Teeth upwards from a bar, and the same downwards with its tips at y = 0, as a drawing program turns and rounds them.
Polygon drawn_comb(int n, bool downwards, double angle) {
  const int teeth = (n - 2) / 4;
  const double half_width = 0.2, height = 10, thickness = 1;
  Polygon comb{{-0.5, -thickness}, {teeth - 0.5, -thickness}};
  for (int k = teeth; k-- > 0;) {
    for (const auto& [x, y] : {Point{k + half_width, 0}, Point{k + half_width, height}, Point{k - half_width, height},
                               Point{k - half_width, 0}})
      comb.push_back({x, y});
  }
  for (Point& p : comb) {
    if (downwards) p = {teeth - 1 - p.x, height - p.y};
    p = turned(p, angle);
  }
  return comb;
}

MotionPiece drawn_piece(const std::vector<Point>& terms, double angle, double until) {
  MotionPiece piece;
  for (const Point& term : terms) {
    const Point p = turned(term, angle);
    piece.x.push_back(p.x);
    piece.y.push_back(p.y);
  }
  piece.until = until;
  return piece;
}

/// One comb dips into the other on a parabola, is moved on by one slot, and dips again, eight times; everything turned.
Scene combs_dip(int n) {
  const double angle = 0.37, top = 10.5, depth = 9.5, drift = 0.05;
  constexpr int dips = 8;
  Scene scene;
  scene.end = 2 * dips - 1;
  Motion motion;
  double x = 0.475;
  for (int k = 0; k < dips; ++k) {
    const double t = 2 * k;
    // top - 4 depth u (1 - u) and x + drift u with u = time - t, by powers of the time.
    motion.pieces.push_back(
        drawn_piece({{x - drift * t, top + 4 * depth * t * (1 + t)}, {drift, -4 * depth * (1 + 2 * t)}, {0, 4 * depth}},
                    angle, t + 1));
    x += drift;
    const double aside = 1 - drift;
    motion.pieces.push_back(drawn_piece({{x - aside * (t + 1), top}, {aside, 0}}, angle, t + 2));
    x += aside;
  }
  motion.pieces.pop_back();
  scene.bodies = {{"lower", drawn_comb(n, false, angle), {}}, {"upper", drawn_comb(n, true, angle), motion}};
  return scene;
}

/// The same on a grid: nothing turned, and nothing rounded.
Scene combs_dip_on_grid(int n) {
  Scene scene = combs_dip(n);
  scene.bodies[0].polygon = drawn_comb(n, false, 0);
  scene.bodies[1].polygon = drawn_comb(n, true, 0);
  Motion motion;
  for (int k = 0; k < 8; ++k) {
    const double t = 2 * k, x = 0.5 + k;
    motion.pieces.push_back(drawn_piece({{x, 10.5 + 38 * t * (1 + t)}, {0, -38 * (1 + 2 * t)}, {0, 38}}, 0, t + 1));
    motion.pieces.push_back(drawn_piece({{x - (t + 1), 10.5}, {1, 0}}, 0, t + 2));
  }
  motion.pieces.pop_back();
  scene.bodies[1].motion = motion;
  return scene;
}

Motion turning(double angle, Point pivot, Point at) {
  MotionPiece piece;
  piece.x = {at.x};
  piece.y = {at.y};
  piece.rotation = AngleRotation{{0, angle}};
  piece.pivot = pivot;
  return Motion{{piece}};
}

/// A lid with collinear points on its rim opens about a corner on a box with the same points.
Scene lid_on_rim() {
  Scene scene;
  scene.end = 1;
  const Polygon box{{0, -3}, {12, -3}, {12, 0}, {10, 0}, {8, 0}, {6, 0}, {4, 0}, {2, 0}, {0, 0}};
  const Polygon lid{{0, 0},  {2, 0},  {4, 0}, {6, 0}, {8, 0}, {10, 0}, {12, 0},
                    {12, 1}, {10, 1}, {8, 1}, {6, 1}, {4, 1}, {2, 1},  {0, 1}};
  scene.bodies = {{"box", box, {}}, {"lid", lid, turning(1.5, {0, 0}, {0, 0})}};
  return scene;
}

/// Leaves of a hinge with square knuckles on a grid swing about a corner that they share.
Scene hinge(int knuckles) {
  const auto leaf = [knuckles](double side) {
    Polygon p{{0, 0}};
    for (int k = 0; k < knuckles; ++k) {
      const double x = 4.0 * k + 2;
      for (const Point& q : {Point{x, 0}, Point{x, 1}, Point{x + 2, 1}, Point{x + 2, 0}}) p.push_back(q);
    }
    const double end = 4.0 * knuckles + 2;
    for (const Point& q : {Point{end, 0}, Point{end, 3}, Point{0, 3}}) p.push_back(q);
    for (Point& q : p) q.y *= side;
    return p;
  };
  Scene scene;
  scene.end = 1;
  Polygon fixed = leaf(-1);
  scene.bodies = {{"fixed", fixed, {}}, {"swinging", leaf(1), turning(3, {0, 0}, {0, 0})}};
  return scene;
}

/// Two equal cams with eight corners turn past each other in opposite directions.
Scene symmetric_cams(int corners) {
  Polygon cam;
  for (int k = 0; k < corners; ++k) cam.push_back(gen::polar(k % 2 == 0 ? 1 : 0.75, 2 * gen::pi * k / corners));
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"left", cam, turning(2 * gen::pi, {}, {})}, {"right", cam, turning(-2 * gen::pi, {}, {2.125, 0})}};
  return scene;
}

/// A key with wards on a grid turns within a round of square chambers.
Scene key_turning(int wards) {
  Polygon key, chamber;
  const double reach = 2 * wards + 1;
  for (int k = 0; k < wards; ++k) {
    for (const Point& q :
         {Point{2.0 * k, 0.5}, Point{2.0 * k, 0.25}, Point{2.0 * k + 1, 0.25}, Point{2.0 * k + 1, 0.5}})
      key.push_back(q);
  }
  key.push_back({reach, 0.5});
  key.push_back({reach, 0.75});
  key.push_back({0, 0.75});
  for (Point& q : key) q.y -= 0.5;
  std::reverse(key.begin(), key.end());
  // An open box around all that the key can reach, its walls with a point at every unit.
  const auto size = static_cast<int>(reach) + 1;
  for (int k = -size; k <= size; ++k) chamber.push_back({double(k), double(-size)});
  for (int k = 1 - size; k <= size; ++k) chamber.push_back({double(size), double(k)});
  chamber.push_back({double(size) + 1, double(size)});
  chamber.push_back({double(size) + 1, double(-size) - 1});
  chamber.push_back({double(-size) - 1, double(-size) - 1});
  chamber.push_back({double(-size) - 1, double(size)});
  for (int k = size; k > -size; --k) chamber.push_back({double(-size), double(k)});
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"chamber", chamber, {}}, {"key", key, turning(6, {}, {})}};
  return scene;
}

}  // namespace

std::vector<TiedScene> tied_scenes() {
  return {{"combs pulled apart, 16 teeth", combs_apart(16)},
          {"combs pulled apart, 128 teeth", combs_apart(128)},
          {"a key in its lock, 4 steps", key_in_lock(4)},
          {"a key in its lock, 64 steps", key_in_lock(64)},
          {"through a maze, 3 passes", ship_in_maze(3)},
          {"through a maze, 10 passes", ship_in_maze(10)},
          {"two equal octagons", equal_octagons()},
          {"over a row of blocks", over_blocks(40)},
          {"combs dip, turned, n = 64", combs_dip(64)},
          {"combs dip, turned, n = 256", combs_dip(256)},
          {"combs dip on a grid, n = 64", combs_dip_on_grid(64)},
          {"combs dip on a grid, n = 256", combs_dip_on_grid(256)},
          {"square gears, n = 64", square_gears(64)},
          {"square gears, n = 512", square_gears(512)},
          {"a lid on its rim", lid_on_rim()},
          {"a hinge, 4 knuckles", hinge(4)},
          {"symmetric cams, 16 corners", symmetric_cams(16)},
          {"a key turning, 5 wards", key_turning(5)}};
}

Scene nudged(Scene scene) {
  gen::Random random(1);
  // Bodies that rest on each other are lifted first.
  if (check(scene).touching) {
    for (Point& p : scene.bodies[0].polygon) p.y -= 4 * nudge;
  }
  for (Body& body : scene.bodies) {
    for (Point& p : body.polygon) p = {p.x + random.uniform(-nudge, nudge), p.y + random.uniform(-nudge, nudge)};
  }
  return scene;
}

}  // namespace taut::bench
