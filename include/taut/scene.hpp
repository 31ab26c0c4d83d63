// A scene: bodies, their motions, and the time interval in question.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/motion.hpp"

namespace taut {

class PreparedShape;

/// A rigid body: the interior of a simple polygon, moving.
struct Body {
  std::string name;
  Polygon polygon;
  Motion motion;
  /// What prepare(polygon) returned (taut/shape.hpp), for scenes of shapes that come again; may be null. `polygon` is
  /// then best left empty. If it is not, each check compares it with the prepared one, and anything but the same
  /// polygon is an InputError.
  std::shared_ptr<const PreparedShape> prepared = nullptr;
  /// What the user calls it by: a JSON value, as text, which is handed through to answers; may be empty.
  std::string id = {};
};

/// Bodies and a closed time interval [start, end] (start <= end). How many bodies can be decided at present, validate()
/// knows (taut/validate.hpp).
struct Scene {
  double start = 0;
  double end = 0;
  std::vector<Body> bodies;
  /// What the user calls it by: a JSON value, as text, which is handed through to the answer; may be empty.
  std::string id = {};
};

/// What counts as a collision.
enum class Touch {
  open,    ///< the interiors overlap; touching without overlap is no collision
  closed,  ///< touching counts
};

}  // namespace taut
