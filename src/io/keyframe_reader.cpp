#include "io/keyframe_reader.hpp"

#include <optional>

#include "io/json_numbers.hpp"
#include "io/json_object.hpp"

namespace taut::io {

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
    const JsonObject object(document_, token, here, {"t", "x", "y", "angle_deg"},
                            R"(a keyframe as {"t":0,"x":0,"y":0,"angle_deg":0})");
    Keyframe keyframe;
    const std::size_t t = object.get("t");
    keyframe.t = read_number(document_, t, object.path("t"));
    for (std::size_t k = 0; k < std::size(columns); ++k) {
      const auto value = object.find(columns[k].key);
      if (index == 0) given_[k] = value.has_value();
      if (value.has_value() != given_[k]) fail_column(token, here, columns[k].key, given_[k]);
      if (value) keyframe.*columns[k].member = read_number(document_, *value, object.path(columns[k].key));
    }
    if (index > 0 && !(last_ < keyframe.t)) {
      throw document_.error(t, here + ".t", "not later than \"t\" of the keyframe before",
                            "order the keyframes by time; no two may have the same");
    }
    last_ = keyframe.t;
    return keyframe;
  }

 private:
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
  document.require(token, JsonKind::array, path, std::string("the keyframes as ") + keyframes_shape);
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

}  // namespace taut::io
