// An arm goes towards a wall, and is told on the way to turn back.
#include <iostream>
#include <taut/taut.hpp>

int main() {
  taut::Scene scene;
  scene.start = 0;
  scene.end = 10;
  scene.bodies = {{"wall", {{8, -5}, {9, -5}, {9, 5}, {8, 5}}, {}},
                  {"arm", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, taut::from_velocity({1, 0})}};
  std::cout << "as planned: " << to_string(taut::check(scene).outcome) << '\n';

  taut::Simulation simulation(scene);
  while (const auto next = simulation.next_event()) {
    if (next->hi > 5) break;
    simulation.step();
  }
  simulation.advance_to(5);
  // At t = 5 the arm is at x = 5. It goes back as fast as it came.
  taut::Motion back = taut::from_keyframes({{5, 5, 0, 0}, {10, 0, 0, 0}});
  simulation.set_motion(1, back);
  const bool free = simulation.advance_to(scene.end) == taut::SimulationState::finished;
  std::cout << "turned back: " << (free ? "free" : "contact") << '\n';
}
