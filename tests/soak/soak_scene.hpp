// The scenes of the soak: one for each number.
#pragma once

#include <string>

#include "injectors.hpp"

namespace taut::testing {

struct SoakScene {
  Scene scene;
  std::string family;  ///< of polygons, or a generator of `taut gen`
  Injection injection = Injection::none;
  Touch touch = Touch::open;
};

/// Scene `number`; the same everywhere.
SoakScene soak_scene(std::uint64_t number);
/// The same of contact_scene(), whose numbers mean other scenes.
SoakScene soak_contact_scene(std::uint64_t number);

}  // namespace taut::testing
