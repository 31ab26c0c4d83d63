// A cart in a town: does it come through, and if not, what does it meet?
#include <iostream>
#include <taut/taut.hpp>

int main() {
  std::vector<taut::Body> houses;
  for (int i = 0; i < 100; ++i) {
    const double x = 4 * (i % 10), y = 4 * (i / 10);
    houses.push_back({"house " + std::to_string(i), {{x, y}, {x + 3, y}, {x + 3, y + 3}, {x, y + 3}}, {}});
  }
  const taut::StaticMap town(houses);
  const taut::StaticMap::Mover cart =
      town.prepare({"cart", {{-0.25, -0.25}, {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}}, {}});
  const taut::Motion street = taut::from_keyframes({{0, 3.5, 0, 0}, {9, 3.5, 36, 0}, {12, 15.5, 36, 0}});
  const taut::Answer answer = town.check(cart, street, 0, 12);
  std::cout << taut::to_string(answer.outcome);
  if (answer.pair) std::cout << " with " << town.body((*answer.pair)[0]).name;
  // Is a placement free? By the same exact signs.
  const bool blocked = town.overlapped(cart, street, 0).has_value();
  std::cout << (blocked ? ", blocked at the start" : "") << '\n';
}
