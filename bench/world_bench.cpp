// Simulations of worlds of many bodies, one of which changes its plan again and again.
#include <cmath>
#include <numbers>

#include "bench.hpp"
#include "generators/shapes.hpp"
#include "taut/simulation.hpp"

namespace taut::bench {
namespace {

constexpr int changes = 100;
constexpr double beat = 0.01;

/// Of 12 vertices, on a grid with room between them; the time is so long that most would meet.
Scene crowd(int bodies, bool moving) {
  gen::Random random(1);
  const int side = static_cast<int>(std::ceil(std::sqrt(bodies)));
  Scene scene;
  scene.end = 100;
  for (int i = 0; i < bodies; ++i) {
    Body body;
    body.name = "body " + std::to_string(i);
    for (int k = 0; k < 12; ++k) {
      const double angle = k * std::numbers::pi / 6, radius = random.uniform(0.7, 1);
      body.polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const double vx = random.uniform(-0.3, 0.3), vy = random.uniform(-0.3, 0.3);
    body.motion.pieces = {gen::translation({4.0 * (i % side), moving ? vx : 0}, {4.0 * (i / side), moving ? vy : 0})};
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

/// The body in the middle gets another velocity at each beat. `set_motion` alone is what the row is about.
void changes_of_plan(benchmark::State& state, int bodies, bool moving) {
  const Scene scene = crowd(bodies, moving);
  const int side = static_cast<int>(std::ceil(std::sqrt(bodies)));
  const BodyId wanderer = side * (side / 2) + side / 2;
  double going_on = 0;
  for (auto _ : state) {
    gen::Random random(5);
    Simulation simulation(scene);
    const Motion& first = scene.bodies[static_cast<std::size_t>(wanderer)].motion;
    Point at{first.pieces[0].x[0], first.pieces[0].y[0]}, speed{0, 0};
    if (moving) speed = {first.pieces[0].x[1], first.pieces[0].y[1]};
    double changing = 0;
    for (int k = 1; k <= changes; ++k) {
      const double now = k * beat;
      const Stopwatch watch;
      simulation.advance_to(now);
      going_on += watch.seconds();
      at = {at.x + speed.x * beat, at.y + speed.y * beat};
      speed = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
      const Motion motion{{gen::translation({at.x - speed.x * now, speed.x}, {at.y - speed.y * now, speed.y})}};
      const Stopwatch change;
      simulation.set_motion(wanderer, motion);
      changing += change.seconds();
    }
    if (simulation.state() != SimulationState::running) fail(state, "it does not run");
    state.SetIterationTime(changing / changes);
  }
  state.counters["us/advance"] = 1e6 * going_on / static_cast<double>(state.iterations()) / changes;
}

}  // namespace

void register_worlds(bool quick) {
  for (const bool moving : {false, true}) {
    for (const int bodies : {100, 1000, 10000}) {
      const std::string name = std::string("world/plans/") + (moving ? "moving/" : "resting/") + std::to_string(bodies);
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& s) { changes_of_plan(s, bodies, moving); })
          ->UseManualTime()
          ->Iterations(quick || bodies > 1000 ? 1 : 5)
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace taut::bench
