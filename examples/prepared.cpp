// A pin falls in many places: where does it come down to the plate?
#include <iostream>
#include <taut/taut.hpp>

int main() {
  const auto plate = taut::prepare({{0, 0}, {9, 0}, {9, 1}, {6, 1}, {6, 4}, {5, 4}, {5, 1}, {3, 1}, {3, 4}, {0, 4}});
  const auto pin = taut::prepare({{0, 6}, {1, 6}, {1, 7}, {0, 7}});
  for (double x = 0; x < 9; ++x) {
    taut::Scene scene;
    scene.end = 5;
    const taut::Motion fall = taut::from_keyframes({{0, x, 0, 0}, {5, x, -5, 0}});
    scene.bodies = {{"plate", {}, {}, plate}, {"pin", {}, fall, pin}};
    std::cout << (taut::check(scene).outcome == taut::Outcome::free ? '-' : 'x');
  }
  std::cout << '\n';
}
