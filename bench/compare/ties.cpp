#include "compare/ties.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "compare/timing.hpp"
#include "families.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "taut/check.hpp"
#include "taut/shape.hpp"

namespace taut::bench {
namespace {

/// By up to a ten millionth in either direction: far more than doubles resolve, and far less than the play.
constexpr double nudge = 1e-7;

struct Drawing {
  std::string name;
  Scene scene;
};

Scene nudged(Scene scene) {
  gen::Random random(1);
  for (Body& body : scene.bodies) {
    for (Point& p : body.polygon) p = {p.x + random.uniform(-nudge, nudge), p.y + random.uniform(-nudge, nudge)};
  }
  return scene;
}

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

std::vector<Drawing> drawings() {
  return {{"combs pulled apart, 16 teeth", combs_apart(16)}, {"combs pulled apart, 128 teeth", combs_apart(128)},
          {"a key in its lock, 4 steps", key_in_lock(4)},    {"a key in its lock, 64 steps", key_in_lock(64)},
          {"through a maze, 3 passes", ship_in_maze(3)},     {"through a maze, 10 passes", ship_in_maze(10)},
          {"two equal octagons", equal_octagons()},          {"over a row of blocks", over_blocks(40)}};
}

void prepare_bodies(Scene& scene) {
  for (Body& body : scene.bodies) {
    body.prepared = prepare(body.polygon, body.name);
    body.polygon.clear();
  }
}

}  // namespace

bool compare_ties(double seconds) {
  fmt::print("{}\n\n| scene | vertices | events | on the grid | nudged | ratio |\n|---|---:|---:|---:|---:|---:|\n",
             machine_text());
  bool right = true;
  for (Drawing& drawing : drawings()) {
    Scene moved = nudged(drawing.scene);
    const std::size_t vertices = drawing.scene.bodies[0].polygon.size() + drawing.scene.bodies[1].polygon.size();
    prepare_bodies(drawing.scene);
    prepare_bodies(moved);
    Timing on_grid, off_grid;
    Answer first, second;
    const Stopwatch whole;
    for (int round = 0; round < 3 || (whole.seconds() < seconds && round < 101); ++round) {
      on_grid.measure([&] { first = check(drawing.scene); });
      off_grid.measure([&] { second = check(moved); });
    }
    right = right && first.outcome == second.outcome && first.outcome != Outcome::undecided;
    fmt::print("| {} | {} | {} | {} | {} | {:.2g} |\n", drawing.name, vertices, first.events,
               seconds_text(on_grid.median()), seconds_text(off_grid.median()), on_grid.median() / off_grid.median());
    std::fflush(stdout);
  }
  return right;
}

}  // namespace taut::bench
