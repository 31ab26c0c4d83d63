#include "io/mechanism_reader.hpp"

#include <algorithm>
#include <set>

#include "io/json_object.hpp"
#include "io/text_file.hpp"

namespace taut::internal::io {
namespace {

const char* const mechanism_shape =
    R"("mechanism": {"ground": "base", "joints": {"A": {"revolute": ["base", "crank"], "at": [0, 0]}}, "drive": {"A": {"from_deg": 0, "to_deg": 360}}})";
const char* const joint_shape =
    R"({"revolute": ["base", "crank"], "at": [x, y]}, or {"slide": ["base", "piston"], "direction": [dx, dy]})";
const char* const drive_shape =
    R"({"from_deg": 0, "to_deg": 360} for a revolute joint, {"from": 0, "to": 10} for a slide, keyframes [{"t": 0, "deg": 0}, ...], or a polynomial {"deg": [c0, c1, ...]})";
const char* const coupling_shape = R"("couple": [{"joint": "P", "to": "A", "times": -1.5}])";

const char* const range_shape = R"("drive": {"A": [0, 90]}, in degrees or lengths from the drawn pose)";

class MechanismReader {
 public:
  MechanismReader(const JsonDocument& document, double start, double end)
      : document_(document), start_(start), end_(end) {}
  /// Drives are ranges, and added to the joints.
  MechanismReader(const JsonDocument& document, std::vector<Joint>& ranges) : document_(document), ranges_(&ranges) {}

  Mechanism read(std::size_t token) {
    const JsonObject object(document_, token, "mechanism", {"ground", "joints", "drive", "couple"}, mechanism_shape);
    mechanism_.ground = text(object.get("ground"), object.path("ground"), R"("ground": "base")");
    for_each_member(
        object.get("joints"), object.path("joints"), mechanism_shape,
        [this](const std::string& name, std::size_t value, const std::string& path) { read_joint(name, value, path); });
    for_each_member(
        object.get("drive"), object.path("drive"), mechanism_shape,
        [this](const std::string& name, std::size_t value, const std::string& path) { read_drive(name, value, path); });
    if (const auto couple = object.find("couple")) read_couplings(*couple, object.path("couple"));
    return std::move(mechanism_);
  }

 private:
  template <class Visit>
  void for_each_member(std::size_t token, const std::string& path, const std::string& shape, const Visit& visit) const {
    document_.require(token, JsonKind::object, path, shape);
    std::set<std::string> names;
    for (std::size_t i = token + 1; i < document_.after(token); i = document_.after(i + 1)) {
      const std::string& name = document_.string_at(i);
      const std::string member = path + "." + excerpt(name);
      if (!names.insert(name).second)
        throw document_.error(i, member, "this name is there twice", "give joints different names");
      visit(name, i + 1, member);
    }
  }

  std::string text(std::size_t token, const std::string& path, const std::string& shape) const {
    document_.require(token, JsonKind::string, path, shape);
    return document_.string_at(token);
  }

  Point vector(std::size_t token, const std::string& path) const {
    const auto numbers = read_numbers(document_, token, path, "[x, y]", 2, "write [x, y]");
    if (numbers.size() != 2)
      throw document_.error(token, path, "expected two numbers, found " + std::to_string(numbers.size()),
                            "write [x, y]");
    return {numbers[0], numbers[1]};
  }

  void read_joint(const std::string& name, std::size_t token, const std::string& path) {
    const JsonObject object(document_, token, path, {"revolute", "slide", "at", "direction"}, joint_shape);
    const auto revolute = object.find("revolute"), slide = object.find("slide");
    if (revolute.has_value() == slide.has_value())
      throw document_.error(token, path,
                            revolute ? "both \"revolute\" and \"slide\" are given" : "no kind of joint is given",
                            std::string("write ") + joint_shape);
    if (object.find(revolute ? "direction" : "at"))
      throw document_.error(token, path, revolute ? "a revolute joint has no \"direction\"" : "a slide has no \"at\"",
                            std::string("write ") + joint_shape);
    MechanismJoint joint;
    joint.name = name;
    joint.kind = revolute ? MechanismJoint::Kind::revolute : MechanismJoint::Kind::slide;
    if (revolute) joint.at = vector(object.get("at"), object.path("at"));
    if (slide) joint.direction = vector(object.get("direction"), object.path("direction"));
    const std::vector<std::string> bodies = read_bodies(
        revolute ? *revolute : *slide, object.path(revolute ? "revolute" : "slide"), revolute ? SIZE_MAX : 2);
    joint.first = bodies[0];
    joint.shared = bodies.size() > 2;
    for (std::size_t k = 1; k < bodies.size(); ++k) {
      joint.second = bodies[k];
      mechanism_.joints.push_back(joint);
    }
  }

  std::vector<std::string> read_bodies(std::size_t token, const std::string& path, std::size_t most) const {
    document_.require(token, JsonKind::array, path, joint_shape);
    std::vector<std::string> names;
    for (std::size_t i = token + 1; i < document_.after(token); i = document_.after(i))
      names.push_back(text(i, element_path(path, names.size()), joint_shape));
    if (names.size() < 2 || names.size() > most)
      throw document_.error(token, path, "expected two bodies, found " + std::to_string(names.size()),
                            std::string("write ") + joint_shape);
    return names;
  }

  MechanismJoint::Kind kind_of(const std::string& name, std::size_t token, const std::string& path) const {
    std::vector<std::string> names;
    for (const MechanismJoint& joint : mechanism_.joints) {
      if (joint.name == name) return joint.kind;
      names.push_back(joint.name);
    }
    throw document_.error(token, path, "there is no joint \"" + excerpt(name) + "\"", hint_for_name(name, names));
  }

  void read_drive(const std::string& name, std::size_t token, const std::string& path) {
    const bool slides = kind_of(name, token, path) == MechanismJoint::Kind::slide;
    if (ranges_) return read_range(name, token, path);
    Drive drive{name, {}};
    if (document_.at(token).kind() == JsonKind::array) {
      read_keyframes(token, path, slides, drive);
    } else {
      read_line_or_polynomial(token, path, slides, drive);
    }
    mechanism_.drives.push_back(std::move(drive));
  }

  void read_range(const std::string& name, std::size_t token, const std::string& path) {
    const auto range = read_numbers(document_, token, path, range_shape, 2, std::string("write ") + range_shape);
    if (range.size() != 2)
      throw document_.error(token, path, "expected two numbers, found " + std::to_string(range.size()),
                            std::string("write ") + range_shape);
    if (std::any_of(ranges_->begin(), ranges_->end(), [&](const Joint& joint) { return joint.name == name; }))
      throw document_.error(token, path, "\"joints\" has a joint of this name, too", "give one of them another name");
    ranges_->push_back({name, range[0], range[1]});
  }

  void read_line_or_polynomial(std::size_t token, const std::string& path, bool slides, Drive& drive) const {
    const std::string from = slides ? "from" : "from_deg", to = slides ? "to" : "to_deg",
                      value = slides ? "value" : "deg";
    const JsonObject object(document_, token, path, {from, to, value}, drive_shape);
    Drive::Piece piece;
    if (const auto polynomial = object.find(value)) {
      if (object.find(from) || object.find(to))
        throw document_.error(token, path, "both a polynomial and \"" + from + "\" or \"" + to + "\" are given",
                              std::string("write ") + drive_shape);
      piece.polynomial = read_numbers(document_, *polynomial, object.path(value), "[c0, c1, ...]", max_degree + 1,
                                      "the highest degree supported is " + std::to_string(max_degree));
      if (piece.polynomial.empty())
        throw document_.error(*polynomial, object.path(value), "it has no coefficients",
                              "write [c0, c1, ...], [0] for a joint that is held");
    } else {
      piece.line = {start_, read_number(document_, object.get(from), object.path(from)), end_,
                    read_number(document_, object.get(to), object.path(to))};
    }
    drive.pieces.push_back(std::move(piece));
  }

  /// Straight lines between them; constant before the first and after the last.
  void read_keyframes(std::size_t token, const std::string& path, bool slides, Drive& drive) const {
    const std::string key = slides ? "value" : "deg";
    std::vector<std::array<double, 2>> frames;
    for (std::size_t i = token + 1; i < document_.after(token); i = document_.after(i)) {
      const std::string place = element_path(path, frames.size());
      if (document_.at(i).kind() == JsonKind::number)
        throw document_.error(i, place, "expected a keyframe, found a number",
                              std::string("write ") + drive_shape +
                                  "; a range [lo, hi] is for scenes without \"time\", which `taut envelope` and "
                                  "`taut path` take");
      const JsonObject object(document_, i, place, {"t", key}, drive_shape);
      frames.push_back({read_number(document_, object.get("t"), object.path("t")),
                        read_number(document_, object.get(key), object.path(key))});
      if (frames.size() > 1 && !(frames[frames.size() - 2][0] < frames.back()[0]))
        throw document_.error(i, place, "its time is not later than that of the keyframe before",
                              "order keyframes by time");
    }
    if (frames.empty())
      throw document_.error(token, path, "there are no keyframes", std::string("write ") + drive_shape);
    if (frames.front()[0] > start_ || frames.back()[0] < end_)
      throw document_.error(token, path, "the keyframes do not cover the scene's time",
                            "write one for its start and one for its end");
    for (std::size_t k = 1; k < frames.size(); ++k) {
      Drive::Piece piece;
      piece.line = {frames[k - 1][0], frames[k - 1][1], frames[k][0], frames[k][1]};
      if (k + 1 < frames.size()) piece.until = frames[k][0];
      drive.pieces.push_back(piece);
    }
    if (frames.size() == 1) {
      drive.pieces.emplace_back();
      drive.pieces.back().polynomial = {frames[0][1]};
    }
  }

  void read_couplings(std::size_t token, const std::string& path) {
    document_.require(token, JsonKind::array, path, coupling_shape);
    for (std::size_t i = token + 1; i < document_.after(token); i = document_.after(i)) {
      const std::string place = element_path(path, mechanism_.couplings.size());
      const JsonObject object(document_, i, place, {"joint", "to", "times", "plus"}, coupling_shape);
      Coupling coupling;
      coupling.joint = text(object.get("joint"), object.path("joint"), coupling_shape);
      coupling.to = text(object.get("to"), object.path("to"), coupling_shape);
      kind_of(coupling.joint, object.get("joint"), object.path("joint"));
      kind_of(coupling.to, object.get("to"), object.path("to"));
      if (const auto times = object.find("times"))
        coupling.times = read_number(document_, *times, object.path("times"));
      if (const auto plus = object.find("plus")) {
        if (read_number(document_, *plus, object.path("plus")) != 0)
          throw document_.error(*plus, object.path("plus"),
                                "in the drawn pose all joints have the value 0, so this must be 0",
                                "leave it out, and draw the bodies where they are in that pose");
      }
      mechanism_.couplings.push_back(std::move(coupling));
    }
  }

  const JsonDocument& document_;
  double start_ = 0, end_ = 0;
  std::vector<Joint>* ranges_ = nullptr;
  Mechanism mechanism_;
};

}  // namespace

Mechanism read_mechanism(const JsonDocument& document, std::size_t token, double start, double end) {
  return MechanismReader(document, start, end).read(token);
}

Mechanism read_mechanism_with_ranges(const JsonDocument& document, std::size_t token, std::vector<Joint>& joints) {
  const std::vector<Joint> others = joints;
  Mechanism mechanism = MechanismReader(document, joints).read(token);
  for (const Joint& joint : others) {
    for (const MechanismJoint& own : mechanism.joints) {
      if (own.name == joint.name)
        throw document.error(token, "mechanism", "\"joints\" has a joint \"" + excerpt(joint.name) + "\", too",
                             "give one of them another name; the range of a driven joint is written in \"drive\"");
    }
  }
  return mechanism;
}

}  // namespace taut::internal::io
