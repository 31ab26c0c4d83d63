#include "io/joint_reader.hpp"

#include <algorithm>

#include "io/json_numbers.hpp"
#include "io/json_object.hpp"
#include "io/text_file.hpp"

namespace taut::internal::io {
namespace {

const char* const joints_shape = R"("joints": {"lift": [0, 60], "reach": [0, 2.5]}, in degrees or lengths)";
const char* const joint_motion_shape =
    R"({"revolute": {"pivot": [x, y], "by": "lift"}}, or {"slide": {"direction": [dx, dy], "by": "reach"}})";

class JointMotionReader {
 public:
  JointMotionReader(const JsonDocument& document, const std::string& path, const std::vector<Joint>& joints)
      : document_(document), path_(path), joints_(joints) {}

  JointMotion read(std::size_t token) const {
    const JsonObject object(document_, token, path_, {"revolute", "slide"}, joint_motion_shape);
    const auto revolute = object.find("revolute"), slide = object.find("slide");
    if (revolute.has_value() == slide.has_value())
      throw document_.error(token, path_, revolute ? "both \"revolute\" and \"slide\" are given" : "no motion is given",
                            std::string("write ") + joint_motion_shape);
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
    const std::string near = nearest_word(name, names);
    throw document_.error(token, path, "there is no joint \"" + excerpt(name) + "\"",
                          near.empty() ? "name one of \"joints\"" : "is \"" + excerpt(near) + "\" meant?");
  }

  const JsonDocument& document_;
  const std::string& path_;
  const std::vector<Joint>& joints_;
};

}  // namespace

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

}  // namespace taut::internal::io
