// Is this a linkage that can be asked about, and where are its bodies?
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "motion/joint_functions.hpp"
#include "motion/joint_value.hpp"
#include "motion/loop_region.hpp"
#include "scene/linkage.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"

namespace taut::internal {

Scene resting_scene(const Linkage& linkage) {
  Scene scene = linkage.scene;
  scene.start = scene.end = 0;
  scene.mechanism.reset();
  for (Body& body : scene.bodies) body.motion = {};
  return scene;
}

JointAngle joint_angle_of(const JointMotion& motion) {
  constexpr double degree = std::numbers::pi / 180;
  return {motion.times * degree, motion.plus * degree};
}

std::vector<JointMotion> single_motions(const JointMotion& motion) {
  const auto* free = std::get_if<FreeMotion>(&motion.kind);
  if (!free) return {motion};
  std::vector<JointMotion> single;
  if (free->x) single.push_back({Slide{{1, 0}}, *free->x});
  if (free->y) single.push_back({Slide{{0, 1}}, *free->y});
  if (free->deg) single.push_back({Revolute{free->pivot}, *free->deg});
  return single;
}

std::optional<double> value_of_link(const LinkMotion& link, int joint, const JointValues& values) {
  const auto followed = static_cast<std::size_t>(link.follows.joint);
  if (link.region) {
    const auto value = link.region->value(followed, values, {});
    return value ? std::optional(value->middle.mid) : std::nullopt;
  }
  return joint_value<Series<double, 0>>(*link.follows.functions, followed, static_cast<std::size_t>(link.follows.piece),
                                        Ball<double>::exact(values[static_cast<std::size_t>(joint)]))
      .c[0]
      .mid;
}

bool follows(const JointMotion& motion, std::size_t joint) {
  const auto* link = std::get_if<LinkMotion>(&motion.kind);
  if (link && link->region)
    return link->region->depends(static_cast<std::size_t>(link->follows.joint), static_cast<int>(joint));
  const std::vector<JointMotion> single = single_motions(motion);
  return std::any_of(single.begin(), single.end(),
                     [&](const JointMotion& m) { return static_cast<std::size_t>(m.joint) == joint; });
}

}  // namespace taut::internal

namespace taut {
using namespace internal;
namespace {

const char* const ranges_hint = R"(write "joints": {"lift": [0, 60]}, in degrees or lengths)";

void validate_joints(const std::vector<Joint>& joints) {
  if (joints.empty() || joints.size() > static_cast<std::size_t>(max_joints))
    throw InputError("joints", "there are " + std::to_string(joints.size()),
                     "one to four joints can be asked about; let bodies share one by \"times\" and \"plus\"");
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

void validate_single(const JointMotion& motion, const std::vector<Joint>& joints, const std::string& place) {
  if (motion.joint < 0 || static_cast<std::size_t>(motion.joint) >= joints.size())
    throw InputError(place + ".by", "there is no such joint", "name one of \"joints\"");
  if (std::holds_alternative<LinkMotion>(motion.kind)) return;
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

void validate_motion(const JointMotion& motion, const std::vector<Joint>& joints, const std::string& place) {
  const std::vector<JointMotion> single = single_motions(motion);
  if (single.empty())
    throw InputError(place + ".free", "it follows no joint", R"(write {"free": {"x": "x", "y": "y", "deg": "turn"}})");
  for (const JointMotion& m : single) validate_single(m, joints, place);
}

/// What a link of a mechanism does at these values.
void add_to(MotionPiece& piece, const LinkMotion& link, int joint, const JointValues& values) {
  constexpr double degree = std::numbers::pi / 180;
  const JointFollower& follows = link.follows;
  const std::optional<double> known = value_of_link(link, joint, values);
  if (!known)
    throw InputError("mechanism", "at these values of the driven joints it may lock, or it does not get there",
                     "give values that it reaches from the drawn pose");
  const double own = follows.sign * *known;
  if (!follows.slides) {
    piece.rotation = AngleRotation{{own * degree}};
    piece.pivot = link.pivot;
    return;
  }
  const double length = std::hypot(follows.direction.x, follows.direction.y);
  piece.x = {own / length * follows.direction.x};
  piece.y = {own / length * follows.direction.y};
}

/// Adds what one revolute or slide does at these values. The revolute comes last.
void add_to(MotionPiece& piece, const JointMotion& motion, const JointValues& values) {
  if (const auto* link = std::get_if<LinkMotion>(&motion.kind)) return add_to(piece, *link, motion.joint, values);
  const double value = values[static_cast<std::size_t>(motion.joint)];
  if (const auto* revolute = std::get_if<Revolute>(&motion.kind)) {
    const JointAngle angle = joint_angle_of(motion);
    piece.rotation = AngleRotation{{angle.slope * value + angle.offset}};
    piece.pivot = revolute->pivot;
    return;
  }
  const Point& direction = std::get<Slide>(motion.kind).direction;
  const double way = motion.times * value + motion.plus;
  piece.x = {(piece.x.empty() ? 0 : piece.x[0]) + way * direction.x};
  piece.y = {(piece.y.empty() ? 0 : piece.y[0]) + way * direction.y};
}

}  // namespace

void validate(const Linkage& linkage) {
  validate_joints(linkage.joints);
  const auto is_link = [](const auto& motion) { return motion && std::holds_alternative<LinkMotion>(motion->kind); };
  if (linkage.scene.mechanism && std::none_of(linkage.motions.begin(), linkage.motions.end(), is_link))
    throw InputError("mechanism", "its bodies have no motions yet", "ask about assembled(linkage)");
  if (linkage.motions.size() > linkage.scene.bodies.size())
    throw InputError("motions", "there are more of them than bodies", "give each body at most one");
  for (std::size_t i = 0; i < linkage.motions.size(); ++i) {
    if (!linkage.motions[i]) continue;
    validate_motion(*linkage.motions[i], linkage.joints, "bodies[" + std::to_string(i) + "].motion");
  }
  validate_polygons(resting_scene(linkage));
}

Scene posed(const Linkage& linkage, const JointValues& values) {
  Scene scene = resting_scene(linkage);
  for (std::size_t i = 0; i < linkage.motions.size(); ++i) {
    if (!linkage.motions[i]) continue;
    MotionPiece piece;
    for (const JointMotion& motion : single_motions(*linkage.motions[i])) add_to(piece, motion, values);
    scene.bodies[i].motion.pieces = {piece};
  }
  return scene;
}

}  // namespace taut
