#include "io/joint_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "io/json_object.hpp"
#include "io/json_writer.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "motion/loop_region.hpp"
#include "scene/linkage.hpp"
#include "taut/error.hpp"
#include "taut/shape.hpp"

namespace taut::internal::io {
namespace {

const char* const joints_shape = R"("joints": {"lift": [0, 60], "reach": [0, 2.5]}, in degrees or lengths)";
const char* const joint_motion_shape =
    R"({"revolute": {"pivot": [x, y], "by": "lift"}}, {"slide": {"direction": [dx, dy], "by": "reach"}}, or )"
    R"({"free": {"x": "x", "y": "y", "deg": "turn", "pivot": [x, y]}})";

class JointMotionReader {
 public:
  JointMotionReader(const JsonDocument& document, const std::string& path, const std::vector<Joint>& joints)
      : document_(document), path_(path), joints_(joints) {}

  JointMotion read(std::size_t token) const {
    const JsonObject object(document_, token, path_, {"revolute", "slide", "free"}, joint_motion_shape);
    const auto revolute = object.find("revolute"), slide = object.find("slide"), free = object.find("free");
    const int given = revolute.has_value() + slide.has_value() + free.has_value();
    if (given != 1)
      throw document_.error(token, path_, given ? "more than one motion is given" : "no motion is given",
                            std::string("write ") + joint_motion_shape);
    if (free) return read_free(*free, object.path("free"));
    const char* const key = revolute ? "revolute" : "slide";
    const std::string vector = revolute ? "pivot" : "direction";
    const JsonObject inner(document_, revolute ? *revolute : *slide, object.path(key), {vector, "by", "times", "plus"},
                           joint_motion_shape);
    JointMotion motion;
    const Point point = read_vector(inner.get(vector), inner.path(vector));
    if (revolute) {
      motion.kind = Revolute{point};
    } else {
      motion.kind = Slide{point};
    }
    motion.joint = joint_named(inner.get("by"), inner.path("by"));
    if (const auto times = inner.find("times")) motion.times = read_number(document_, *times, inner.path("times"));
    if (const auto plus = inner.find("plus")) motion.plus = read_number(document_, *plus, inner.path("plus"));
    return motion;
  }

 private:
  JointMotion read_free(std::size_t token, const std::string& path) const {
    const JsonObject inner(document_, token, path, {"x", "y", "deg", "pivot"}, joint_motion_shape);
    FreeMotion free;
    const auto read_joint = [&](const char* key, std::optional<int>& joint) {
      if (const auto name = inner.find(key)) joint = joint_named(*name, inner.path(key));
    };
    read_joint("x", free.x);
    read_joint("y", free.y);
    read_joint("deg", free.deg);
    if (const auto pivot = inner.find("pivot")) free.pivot = read_vector(*pivot, inner.path("pivot"));
    JointMotion motion;
    motion.kind = free;
    return motion;
  }
  Point read_vector(std::size_t token, const std::string& path) const {
    const auto numbers = read_numbers(document_, token, path, "[x, y]", 2, "write [x, y]");
    if (numbers.size() != 2)
      throw document_.error(token, path, "expected two numbers, found " + std::to_string(numbers.size()),
                            "write [x, y]");
    return {numbers[0], numbers[1]};
  }
  int joint_named(std::size_t token, const std::string& path) const {
    document_.require(token, JsonKind::string, path, joint_motion_shape);
    const std::string& name = document_.string_at(token);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i].name == name) return static_cast<int>(i);
      names.push_back(joints_[i].name);
    }
    throw document_.error(token, path, "there is no joint \"" + excerpt(name) + "\"", hint_for_name(name, names));
  }

  const JsonDocument& document_;
  const std::string& path_;
  const std::vector<Joint>& joints_;
};

/// What is wrong with a value, with its place in the file.
template <class Require>
void require_at(const JsonDocument& document, std::size_t token, const std::string& path, const Require& require) {
  try {
    require();
  } catch (const InputError& error) {
    throw document.error(token, path, error.problem(), error.hint());
  }
}

/// One value for each joint that is named, by a function of its number, its token and its path.
template <class Read>
void read_values(const JsonDocument& document, std::size_t token, const char* key, const std::vector<Joint>& joints,
                 const Read& read) {
  const std::string shape = std::string("\"") + key + R"(": {"x": 1, "turn": 90})";
  document.require(token, JsonKind::object, key, shape);
  std::vector<std::string> names;
  for (const Joint& joint : joints) names.push_back(joint.name);
  const JsonObject object(document, token, key, names, shape);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (const auto value = object.find(joints[k].name)) read(k, *value, object.path(joints[k].name));
  }
}

}  // namespace

void read_periodic(const JsonDocument& document, std::size_t token, PathProblem& problem) {
  const char* const shape = R"("periodic": ["turn"])";
  document.require(token, JsonKind::array, "periodic", shape);
  const std::vector<Joint>& joints = problem.linkage.joints;
  for (std::size_t i = token + 1; i < document.after(token); i = document.after(i)) {
    document.require(i, JsonKind::string, "periodic", shape);
    const std::string& name = document.string_at(i);
    const auto found = std::find_if(joints.begin(), joints.end(), [&](const Joint& j) { return j.name == name; });
    if (found == joints.end())
      throw document.error(i, "periodic", "there is no joint \"" + excerpt(name) + "\"", "name one of \"joints\"");
    problem.periodic[static_cast<std::size_t>(found - joints.begin())] = true;
  }
}

void read_start(const JsonDocument& document, std::size_t token, PathProblem& problem) {
  std::array<bool, max_joints> given{};
  const std::vector<Joint>& joints = problem.linkage.joints;
  read_values(document, token, "start", joints, [&](std::size_t k, std::size_t value, const std::string& path) {
    problem.start[k] = read_number(document, value, path);
    require_at(document, value, path, [&] { require_start(joints[k], problem.start[k]); });
    given[k] = true;
  });
  for (std::size_t k = 0; k < joints.size(); ++k) {
    if (!given[k])
      throw document.error(token, "start", "it does not name the joint \"" + excerpt(joints[k].name) + "\"",
                           "give each joint a value");
  }
}

namespace {

std::array<double, 2> read_goal_of_joint(const JsonDocument& document, std::size_t token, const std::string& path) {
  if (document.at(token).kind() != JsonKind::array) {
    const double at = read_number(document, token, path);
    return {at, at};
  }
  const auto range = read_numbers(document, token, path, "[lo, hi]", 2, "write [lo, hi]");
  if (range.size() != 2 || range[1] < range[0])
    throw document.error(token, path, "it is no range", "write [lo, hi] with lo no larger than hi");
  return {range[0], range[1]};
}

}  // namespace

void read_goal(const JsonDocument& document, std::size_t token, PathProblem& problem) {
  if (document.at(token).kind() == JsonKind::string) {
    problem.goal_outside = document.string_at(token) == "outside";
    if (problem.goal_outside) return;
    throw document.error(token, "goal", "unknown goal \"" + excerpt(document.string_at(token)) + "\"",
                         R"(write "goal": "outside", or {"x": [8, 9], "y": 7})");
  }
  const std::vector<Joint>& joints = problem.linkage.joints;
  read_values(document, token, "goal", joints, [&](std::size_t k, std::size_t value, const std::string& path) {
    problem.goal[k] = read_goal_of_joint(document, value, path);
    require_at(document, value, path, [&] { require_goal(joints[k], *problem.goal[k]); });
  });
}

std::vector<Joint> read_joints(const JsonDocument& document, std::size_t token) {
  document.require(token, JsonKind::object, "joints", joints_shape);
  std::vector<Joint> joints;
  for (std::size_t i = token + 1; i < document.after(token); i = document.after(i + 1)) {
    const std::string& name = document.string_at(i);
    const std::string path = "joints." + excerpt(name);
    if (std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == name; }))
      throw document.error(i, path, "there are two joints of this name", "give them different names");
    const auto range = read_numbers(document, i + 1, path, "[lo, hi]", 2, "write [lo, hi]");
    if (range.size() != 2)
      throw document.error(i + 1, path, "expected two numbers, found " + std::to_string(range.size()),
                           std::string("write ") + joints_shape);
    joints.push_back({name, range[0], range[1]});
  }
  return joints;
}

std::optional<JointMotion> read_joint_motion(const JsonDocument& document, std::size_t token, const std::string& path,
                                             const std::vector<Joint>& joints) {
  if (document.at(token).kind() == JsonKind::null) return std::nullopt;
  return JointMotionReader(document, path, joints).read(token);
}

namespace {

std::string coordinates(const Point& p) { return array_text({p.x, p.y}); }

std::string outline_json(const Polygon& ring) {
  std::string s = "[";
  for (const Point& p : ring) s += (s.size() > 1 ? "," : "") + coordinates(p);
  return s + "]";
}

std::string part_json(const Polygon& outline, const std::vector<Polygon>& holes) {
  std::string s = "[" + outline_json(outline);
  for (const Polygon& hole : holes) s += "," + outline_json(hole);
  return s + "]";
}

std::string parts_json(const Body& body) {
  if (body.parts.empty()) return "[" + part_json(polygon_of(body), {}) + "]";
  std::string s = "[";
  for (const Part& part : body.parts) s += (s.size() > 1 ? "," : "") + part_json(part.outline, part.holes);
  return s + "]";
}

/// The joints of the linkage that drive a link.
std::vector<int> driving_joints(const LinkMotion& link, int joint) {
  if (!link.region) return {joint};
  std::vector<int> joints;
  for (const LoopRegion::Range& range : link.region->ranges()) joints.push_back(range.joint);
  return joints;
}

/// The values of a link's joint, evenly over the ranges of the joints that drive it, of which the first one varies
/// fastest; null where the mechanism may lock.
std::string link_values_json(const Linkage& linkage, const LinkMotion& link, int joint, const std::vector<int>& by) {
  constexpr std::array counts{513, 33, 13, 7};
  const int count = counts[by.size() - 1];
  std::string s = "[";
  std::vector<int> at(by.size());
  for (std::size_t k = 0; k < by.size();) {
    JointValues values{};
    for (std::size_t i = 0; i < by.size(); ++i) {
      const Joint& driven = linkage.joints[static_cast<std::size_t>(by[i])];
      const double share = static_cast<double>(at[i]) / (count - 1);
      values[static_cast<std::size_t>(by[i])] = driven.lo + share * (driven.hi - driven.lo);
    }
    const std::optional<double> value = value_of_link(link, joint, values);
    s += (s.size() > 1 ? "," : "") + (value ? number_text(link.follows.sign * *value) : "null");
    for (k = 0; k < by.size() && ++at[k] == count; ++k) at[k] = 0;
  }
  return s + "]";
}

std::string link_motion_json(const Linkage& linkage, const LinkMotion& link, int joint) {
  const std::vector<int> by = driving_joints(link, joint);
  const Point& d = link.follows.direction;
  const double length = std::hypot(d.x, d.y);
  std::string joints;
  for (const int k : by) joints += (joints.empty() ? "" : ",") + std::to_string(k);
  return "{\"joint\":" + std::to_string(joint) + (by.size() > 1 ? ",\"joints\":[" + joints + "]" : "") +
         ",\"values\":" + link_values_json(linkage, link, joint, by) +
         (link.follows.slides ? ",\"direction\":" + coordinates({d.x / length, d.y / length})
                              : ",\"pivot\":" + coordinates(link.pivot)) +
         "}";
}

std::string single_motion_json(const Linkage& linkage, const JointMotion& motion) {
  if (const auto* link = std::get_if<LinkMotion>(&motion.kind)) return link_motion_json(linkage, *link, motion.joint);
  const auto* revolute = std::get_if<Revolute>(&motion.kind);
  return "{\"joint\":" + std::to_string(motion.joint) + ",\"times\":" + number_text(motion.times) +
         ",\"plus\":" + number_text(motion.plus) +
         (revolute ? ",\"pivot\":" + coordinates(revolute->pivot)
                   : ",\"direction\":" + coordinates(std::get<Slide>(motion.kind).direction)) +
         "}";
}

/// Revolutes and slides, the outermost first.
std::string joint_motion_json(const Linkage& linkage, const JointMotion& motion) {
  std::string s = "[";
  for (const JointMotion& single : single_motions(motion))
    s += (s.size() > 1 ? "," : "") + single_motion_json(linkage, single);
  return s + "]";
}

std::string linked_body_text(const Linkage& linkage, std::size_t k) {
  const std::vector<Body>& bodies = linkage.scene.bodies;
  std::string s = "{\"name\":" + string_text(bodies[k].name) + ",\"parts\":" + parts_json(bodies[k]);
  const auto parent =
      std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) { return body.name == bodies[k].relative_to; });
  if (!bodies[k].relative_to.empty() && parent != bodies.end())
    s += ",\"parent\":" + std::to_string(parent - bodies.begin());
  if (k < linkage.motions.size() && linkage.motions[k])
    s += ",\"motion\":" + joint_motion_json(linkage, *linkage.motions[k]);
  return s + "}";
}

}  // namespace

std::string linked_bodies_json(const Linkage& linkage) {
  std::string s = "[";
  for (std::size_t k = 0; k < linkage.scene.bodies.size(); ++k) s += (k ? "," : "") + linked_body_text(linkage, k);
  return s + "]";
}

}  // namespace taut::internal::io
