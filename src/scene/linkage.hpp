// How bodies follow joints.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "taut/envelope.hpp"

namespace taut::internal {

/// Is this the name of a joint that can be driven?
bool is_joint_of(const Mechanism& mechanism, const std::string& name);

/// The revolutes and slides that a motion consists of, the outermost first. A revolute is the last one.
std::vector<JointMotion> single_motions(const JointMotion& motion);
/// Does a body with this motion follow the joint?
bool follows(const JointMotion& motion, std::size_t joint);

/// Of a revolute: the angle in radians is slope * value + offset.
struct JointAngle {
  double slope = 0, offset = 0;
};
JointAngle joint_angle_of(const JointMotion& motion);

/// The value of the joint that a link of a mechanism follows, where the linkage's joints have these values: the middle
/// of an enclosure. Nothing where the mechanism may lock. `joint` is that of the link's JointMotion.
std::optional<double> value_of_link(const LinkMotion& link, int joint, const JointValues& values);

/// Throws InputError unless the joint may start there.
void require_start(const Joint& joint, double value);
/// Throws InputError unless some value of the goal is in the joint's range.
void require_goal(const Joint& joint, const std::array<double, 2>& range);

/// The scene without motions, mechanism and time.
Scene resting_scene(const Linkage& linkage);

}  // namespace taut::internal
