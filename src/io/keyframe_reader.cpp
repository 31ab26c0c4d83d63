#include "io/keyframe_reader.hpp"

#include <optional>

#include "io/json_numbers.hpp"
#include "io/json_object.hpp"

namespace taut::internal::io {

namespace {

const char* const keyframes_shape = R"([{"t":0,"x":0,"y":0,"angle_deg":0},{"t":1,"x":5,"y":0,"angle_deg":90},...])";

/// What a keyframe says besides its time. All of a motion must say the same, so that nothing is left to guess: does a
/// keyframe without "x" stay where it was, or go to 0?
struct KeyColumn {
  const char* key;
  double Keyframe::*member;
};
constexpr KeyColumn columns[] = {{"x", &Keyframe::x}, {"y", &Keyframe::y}, {"angle_deg", &Keyframe::angle_deg}};

class KeyframeReader {
 public:
  KeyframeReader(const JsonDocument& document, const std::string& path) : document_(document), path_(path) {}

  Keyframe read(std::size_t token, std::size_t index) {
    const std::string here = element_path(path_, index);
    const JsonObject object(document_, token, here, {"t", "x", "y", "angle_deg", "turn", "arc"},
                            R"(a keyframe as {"t":0,"x":0,"y":0,"angle_deg":0})");
    Keyframe keyframe;
    const std::size_t t = object.get("t");
    keyframe.t = read_number(document_, t, object.path("t"));
    const auto turn = object.find("turn"), arc = object.find("arc");
    if (turn || arc) {
      read_way(object, token, index, turn, arc, keyframe);
    } else {
      read_place(object, token, index, here, keyframe);
    }
    if (index > 0 && !(last_ < keyframe.t)) {
      throw document_.error(t, here + ".t", "not later than \"t\" of the keyframe before",
                            "order the keyframes by time; no two may have the same");
    }
    last_ = keyframe.t;
    return keyframe;
  }

 private:
  /// A segment around a centre: the place follows from the keyframe before.
  void read_way(const JsonObject& object, std::size_t token, std::size_t index, std::optional<std::size_t> turn,
                std::optional<std::size_t> arc, Keyframe& keyframe) const {
    const std::string shape = R"({"t": 1, "turn": {"center": [x, y], "deg": 90}}, or "arc" for "turn")";
    if (index == 0)
      throw document_.error(token, object.path("t"), "the first keyframe goes around a centre",
                            "begin with a keyframe of \"x\", \"y\" and \"angle_deg\"");
    if ((turn && arc) || object.find("x") || object.find("y") || object.find("angle_deg"))
      throw document_.error(token, object.path("t"), "a leg around a centre says where it goes in one way only",
                            "write " + shape);
    const std::string key = turn ? "turn" : "arc";
    const JsonObject way(document_, turn ? *turn : *arc, object.path(key), {"center", "deg"}, shape);
    keyframe.way = turn ? Way::turn : Way::arc;
    const auto centre = read_numbers(document_, way.get("center"), way.path("center"), shape, 2, "write " + shape);
    if (centre.size() != 2)
      throw document_.error(way.get("center"), way.path("center"), "expected two numbers", "write " + shape);
    keyframe.centre = {centre[0], centre[1]};
    keyframe.by_deg = read_number(document_, way.get("deg"), way.path("deg"));
  }

  void read_place(const JsonObject& object, std::size_t token, std::size_t index, const std::string& here,
                  Keyframe& keyframe) {
    for (std::size_t k = 0; k < std::size(columns); ++k) {
      const auto value = object.find(columns[k].key);
      if (index == 0) given_[k] = value.has_value();
      if (value.has_value() != given_[k]) fail_column(token, here, columns[k].key, given_[k]);
      if (value) keyframe.*columns[k].member = read_number(document_, *value, object.path(columns[k].key));
    }
  }

  [[noreturn]] void fail_column(std::size_t token, const std::string& here, const std::string& key, bool given) const {
    const std::string quoted = "\"" + key + "\"";
    throw document_.error(
        token, here, given ? "the key " + quoted + " is missing" : quoted + " is given, but not in the first keyframe",
        "write " + quoted + " in every keyframe or in none (then it is 0)");
  }

  const JsonDocument& document_;
  std::string path_;
  bool given_[std::size(columns)] = {};
  double last_ = 0;
};

}  // namespace

std::vector<Keyframe> read_keyframes(const JsonDocument& document, std::size_t token, const std::string& path,
                                     const ReadLimits& limits) {
  std::string wanted = "the keyframes as ";
  wanted += keyframes_shape;
  document.require(token, JsonKind::array, path, wanted);
  const std::size_t end = document.after(token);
  if (end == token + 1) {
    throw document.error(token, path, "there are no keyframes", std::string("write ") + keyframes_shape);
  }
  KeyframeReader reader(document, path);
  std::vector<Keyframe> keyframes;
  for (std::size_t i = token + 1; i < end; i = document.after(i)) {
    if (keyframes.size() == limits.max_pieces) {
      throw document.error(i, path, "more keyframes than the limit of " + std::to_string(limits.max_pieces),
                           "split the scene in time, or raise ReadLimits::max_pieces");
    }
    keyframes.push_back(reader.read(i, keyframes.size()));
  }
  return keyframes;
}

}  // namespace taut::internal::io
