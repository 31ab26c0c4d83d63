// Is this a linkage that can be asked about, and where are its bodies?
#include <cmath>
#include <set>

#include <algorithm>
#include "query/pose_model.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

const char* const ranges_hint = R"(write "joints": {"lift": [0, 60]}, in degrees or lengths)";

void validate_joints(const std::vector<Joint>& joints) {
  if (joints.empty() || joints.size() > static_cast<std::size_t>(max_joints))
    throw InputError("joints", "there are " + std::to_string(joints.size()),
                     "one to three joints can be asked about; let bodies share one by \"times\" and \"plus\"");
  std::set<std::string> names;
  for (const Joint& joint : joints) {
    const std::string place = "joints." + joint.name;
    if (joint.name.empty()) throw InputError("joints", "a joint has no name", ranges_hint);
    if (!names.insert(joint.name).second)
      throw InputError(place, "there are two of this name", "name them differently");
    if (!std::isfinite(joint.lo) || !std::isfinite(joint.hi) || joint.hi < joint.lo)
      throw InputError(place, "its range does not go from a number to one that is no less", ranges_hint);
  }
}

void validate_motion(const JointMotion& motion, const std::vector<Joint>& joints, const std::string& place) {
  if (motion.joint < 0 || static_cast<std::size_t>(motion.joint) >= joints.size())
    throw InputError(place + ".by", "there is no such joint", "name one of \"joints\"");
  const Joint& joint = joints[static_cast<std::size_t>(motion.joint)];
  const bool turns = std::holds_alternative<Revolute>(motion.kind);
  const Point vector = turns ? std::get<Revolute>(motion.kind).pivot : std::get<Slide>(motion.kind).direction;
  const double most =
      std::fabs(motion.times) * std::max(std::fabs(joint.lo), std::fabs(joint.hi)) + std::fabs(motion.plus);
  for (const double x :
       {vector.x, vector.y, motion.times, motion.plus, most, most * std::fabs(vector.x) + most * std::fabs(vector.y)}) {
    if (!std::isfinite(x)) throw InputError(place, "its numbers are not finite, or too large", "use smaller numbers");
  }
  if (turns && most > 1e6)
    throw InputError(place, "it turns by more than a million degrees", "give the joint a smaller range");
  if (!turns && vector.x == 0 && vector.y == 0)
    throw InputError(place + ".direction", "it is (0, 0)", "give a direction, of length 1 if the joint is a length");
}

/// As it is, without motions.
Scene resting_scene(const Linkage& linkage) {
  Scene scene = linkage.scene;
  scene.start = scene.end = 0;
  for (Body& body : scene.bodies) body.motion = {};
  return scene;
}

}  // namespace

void validate(const Linkage& linkage) {
  validate_joints(linkage.joints);
  if (linkage.motions.size() > linkage.scene.bodies.size())
    throw InputError("motions", "there are more of them than bodies", "give each body at most one");
  for (std::size_t i = 0; i < linkage.motions.size(); ++i) {
    if (!linkage.motions[i]) continue;
    validate_motion(*linkage.motions[i], linkage.joints, "bodies[" + std::to_string(i) + "].motion");
  }
  validate_polygons(resting_scene(linkage));
}

Scene posed(const Linkage& linkage, const std::array<double, max_joints>& values) {
  Scene scene = resting_scene(linkage);
  for (std::size_t i = 0; i < linkage.motions.size(); ++i) {
    if (!linkage.motions[i]) continue;
    const JointMotion& motion = *linkage.motions[i];
    const double value = values[static_cast<std::size_t>(motion.joint)];
    MotionPiece piece;
    if (const auto* revolute = std::get_if<Revolute>(&motion.kind)) {
      const JointAngle angle = joint_angle_of(motion);
      piece.rotation = AngleRotation{{angle.slope * value + angle.offset}};
      piece.pivot = revolute->pivot;
    } else {
      const Point& direction = std::get<Slide>(motion.kind).direction;
      const double way = motion.times * value + motion.plus;
      piece.x = {way * direction.x};
      piece.y = {way * direction.y};
    }
    scene.bodies[i].motion.pieces = {piece};
  }
  return scene;
}

}  // namespace taut
