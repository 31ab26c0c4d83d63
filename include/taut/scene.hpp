// A scene: two bodies, their motions, and the time interval in question.
#pragma once

#include <string>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/motion.hpp"

namespace taut {

/// A rigid body: the interior of a simple polygon, moving.
struct Body {
  std::string name;
  Polygon polygon;
  Motion motion;
};

/// Two bodies and a closed time interval [start, end] (start <= end).
struct Scene {
  double start = 0;
  double end = 0;
  std::vector<Body> bodies;
};

/// What counts as a collision.
enum class Touch {
  open,    ///< the interiors overlap; touching without overlap is no collision
  closed,  ///< touching counts
};

}  // namespace taut
