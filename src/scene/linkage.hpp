// How bodies follow joints.
#pragma once

#include <vector>

#include "taut/envelope.hpp"

namespace taut::internal {

/// The revolutes and slides that a motion consists of, the outermost first. A revolute is the last one.
std::vector<JointMotion> single_motions(const JointMotion& motion);
/// Does a body with this motion follow the joint?
bool follows(const JointMotion& motion, std::size_t joint);

/// Of a revolute: the angle in radians is slope * value + offset.
struct JointAngle {
  double slope = 0, offset = 0;
};
JointAngle joint_angle_of(const JointMotion& motion);

/// The scene without motions and time.
Scene resting_scene(const Linkage& linkage);

}  // namespace taut::internal
