// What holds a follower, at all times: the sequence of its contacts with a cam.
#include <iostream>
#include <taut/taut.hpp>

int main() {
  taut::Scene scene;
  scene.start = -30;
  scene.end = 330;
  // A cam with a hook, which turns by a degree in each unit of time, and a pointed follower above it.
  scene.bodies = {{"cam", {{2, 0}, {-0.5, 1.5}, {0, 4}, {-3, 0}, {0, -2.5}}, taut::from_velocity({0, 0}, 1)},
                  {"follower", {{0, 1}, {0.5, 2}, {0.5, 6}, {-0.5, 6}, {-0.5, 2}}, {}}};
  taut::FollowOptions options;
  options.contacts = true;
  const taut::FollowAnswer answer = taut::follow(scene, 1, {0, 1}, 10, options);
  for (const taut::FollowStretch& s : answer.contacts) {
    std::cout << s.time.lo << ' ' << taut::to_string(s.state) << (s.jumps ? ", it falls" : "");
    if (s.state == taut::FollowState::carried) std::cout << ": " << taut::contact_text(scene, s.contacts[0]);
    std::cout << '\n';
  }
}
