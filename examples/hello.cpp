#include <iostream>
#include <taut/taut.hpp>

int main() {
  taut::Scene scene;
  scene.start = 0;
  scene.end = 10;
  scene.bodies = {{"anvil", {{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}},
                  {"hammer", {{1, 5}, {3, 5}, {2, 6}}, taut::from_velocity({0, -0.5})}};
  const taut::Answer answer = taut::check(scene);
  if (answer.outcome == taut::Outcome::contact) {
    std::cout << "contact at " << answer.contact->time.lo << '\n';  // contact at 8
  } else {
    std::cout << to_string(answer.outcome) << '\n';
  }
}
