// Where a moving body is at one instant, for drawing.
#pragma once

#include <vector>

#include "taut/geometry.hpp"
#include "taut/motion.hpp"
#include "taut/scene.hpp"

namespace taut {

/// A rigid placement: the body's point (u, v) is at origin + u axis + v (axis turned by +90 degrees).
struct BodyPose {
  Point origin;
  Point axis{1, 0};  ///< of unit length up to rounding
};

/// The pose at time t, rounded: good for pictures, no part of a proof. At the joint of two pieces it is that of the
/// later one. `t` must lie where the motion is defined (see validate()); outside, the result may be NaN.
BodyPose pose_at(const Motion& motion, double t);

/// The poses of all bodies of a scene at time t, in its order, seen from the world: those of parents are multiplied in.
/// Rounded like pose_at(). Throws InputError if a parent is missing, or a chain of parents does not end.
std::vector<BodyPose> poses_at(const Scene& scene, double t);

}  // namespace taut
