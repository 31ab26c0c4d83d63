// Two bodies whose bridge is hidden by the far lip of a cavity, of any size.
#pragma once

#include "taut/scene.hpp"

namespace taut::testing {

struct MouthOptions {
  int lip_points = 100;   ///< vertices of each lip, and of the body inside
  double gap = 0.5;       ///< the width of the mouth; the ring's radii are 8 and 10
  double radius = 5;      ///< of the body inside
  double x = 0, y = 0.1;  ///< where it is
};

/// A ring that is open on its right, between two round lips, and a round body inside, which moves slowly.
Scene tight_mouth(const MouthOptions& options);

}  // namespace taut::testing
