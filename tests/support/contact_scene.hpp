// Scenes in which faces lie on one another, corners meet corners, and paths only graze: what random coordinates never
// do. All are small, so that the oracle by definition has an answer to each.
#pragma once

#include <cstdint>
#include <string>

#include "taut/scene.hpp"

namespace taut::testing {

struct ContactScene {
  Scene scene;
  std::string family;
  Touch touch = Touch::open;
};

/// Contact scene `number`; the same everywhere. It may be invalid: blades fold.
ContactScene contact_scene(std::uint64_t number);

}  // namespace taut::testing
