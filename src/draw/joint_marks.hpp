// The joints of a mechanism as pictures show them: a ring where links turn, a pair of rails where they slide.
#pragma once

#include <string>
#include <vector>

#include "draw/world_shapes.hpp"

namespace taut::internal::io {

/// Where a joint is drawn. Its mark moves with a body.
struct JointPlace {
  std::string name;
  std::size_t body = 0;
  Point at;              ///< in the coordinates of that body
  bool slides = false;   ///< along `direction`, which turns with the body
  Point direction = {};  ///< of length 1
};

/// One place for each name. Links turn about a point that their joint's first body carries. A slide is drawn on its
/// second body, deep inside it: what slides is always as parallel to the direction as in the drawn pose.
std::vector<JointPlace> joint_places(const Scene& scene, const WorldShapes& shapes);

/// The mark, centred at the origin, where the body is at `pose`.
std::string joint_mark(const JointPlace& joint, const BodyPose& pose);

}  // namespace taut::internal::io
