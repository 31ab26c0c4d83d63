// A square that slides past another one.
#pragma once

#include "taut/scene.hpp"

namespace taut::testing {

/// `y` is its speed upwards.
inline Scene sliding_square(double y) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"a", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, {"b", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};
  scene.bodies[1].motion.pieces = {{{-3, 1}, {y}, NoRotation{}}};
  return scene;
}

}  // namespace taut::testing
