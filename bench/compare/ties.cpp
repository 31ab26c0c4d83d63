#include "compare/ties.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "compare/tied_scenes.hpp"
#include "compare/timing.hpp"
#include "taut/check.hpp"
#include "taut/shape.hpp"

namespace taut::bench {
namespace {

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
  CheckOptions kinetic;
  kinetic.engine = EngineChoice::kinetic;
  for (TiedScene& drawing : tied_scenes()) {
    Scene moved = nudged(drawing.scene);
    const std::size_t vertices = drawing.scene.bodies[0].polygon.size() + drawing.scene.bodies[1].polygon.size();
    prepare_bodies(drawing.scene);
    prepare_bodies(moved);
    Timing on_grid, off_grid;
    Answer first, second;
    const Stopwatch whole;
    for (int round = 0; round < 3 || (whole.seconds() < seconds && round < 101); ++round) {
      on_grid.measure([&] { first = check(drawing.scene, kinetic); });
      off_grid.measure([&] { second = check(moved, kinetic); });
    }
    right = right && first.outcome == second.outcome && first.outcome != Outcome::undecided;
    fmt::print("| {} | {} | {} | {} | {} | {:.2g} |\n", drawing.name, vertices, first.events,
               seconds_text(on_grid.median()), seconds_text(off_grid.median()), on_grid.median() / off_grid.median());
    std::fflush(stdout);
  }
  return right;
}

}  // namespace taut::bench
