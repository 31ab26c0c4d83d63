// A key in its slot is moved by small steps, and before each it is asked whether it could be pulled up from there.
#include <iostream>
#include <taut/taut.hpp>

int main() {
  const auto lock = taut::prepare({{0, 0}, {9, 0}, {9, 4}, {6, 4}, {6, 1}, {3, 1}, {3, 4}, {0, 4}});
  const auto key = taut::prepare({{0, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1.5, 4}, {0.5, 4}, {0.5, 1}, {0, 1}});
  taut::WarmCheck check;
  for (int k = 0; k < 6; ++k) {
    const double x = 3.25 + 0.1 * k;
    const taut::Motion lift = taut::from_keyframes({{0, x, 1.5, 0}, {1, x + 0.5, 6, 0}});
    taut::Scene scene;
    scene.bodies = {{"lock", {}, {}, lock}, {"key", {}, lift, key}};
    std::cout << (check.check(scene).outcome == taut::Outcome::free ? '-' : 'x');
  }
  std::cout << ", " << check.warm_starts() << " of 6 begun near the one before\n";
}
