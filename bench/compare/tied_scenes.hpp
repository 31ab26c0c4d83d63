// Scenes as drawing programs make them: on grids, with collinear points, parallel edges and equal parts, so that many
// events fall on one instant.
#pragma once

#include <string>
#include <vector>

#include "taut/scene.hpp"

namespace taut::bench {

struct TiedScene {
  std::string name;
  Scene scene;
};

std::vector<TiedScene> tied_scenes();

/// Every coordinate moved a little: far more than doubles resolve, and far less than the play.
Scene nudged(Scene scene);

}  // namespace taut::bench
