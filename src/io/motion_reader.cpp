#include "io/motion_reader.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "io/json_object.hpp"
#include "io/outline_reader.hpp"
#include "motion/rotation_forms.hpp"
#include "taut/motions.hpp"

namespace taut::internal::io {

Coefficients read_coefficients(const JsonDocument& document, std::size_t token, const std::string& path,
                               const std::string& remedy) {
  return read_numbers(document, token, path, "the coefficients in ascending powers of time, as [c0, c1, ...]",
                      max_degree + 1, "the highest degree is " + std::to_string(max_degree) + ": " + remedy);
}

namespace {

/// How each form is written.
std::string rotation_shape() {
  std::string shape;
  for_each_form([&](const auto& form) {
    using Form = FormOf<decltype(form)>;
    if (!*Form::key) return;
    std::string inner;
    for (const auto& polynomial : Form::polynomials)
      inner += (inner.empty() ? "{\"" : ",\"") + std::string(polynomial.name) + "\":[...]";
    shape += (shape.empty() ? "one of {\"" : ", {\"") + std::string(Form::key) +
             "\":" + (Form::polynomials.size() == 1 ? "[...]}" : inner + "}}");
  });
  return shape;
}

Coefficients read_polynomial(const JsonDocument& document, std::size_t token, const std::string& path) {
  return read_coefficients(document, token, path, "lower the degree, or split the motion into pieces with \"until\"");
}

Rotation read_rotation(const JsonDocument& document, std::size_t token, const std::string& path) {
  if (document.at(token).kind() == JsonKind::null) return NoRotation{};
  std::vector<std::string> keys;
  for_each_form([&](const auto& form) {
    if (const std::string key = FormOf<decltype(form)>::key; !key.empty()) keys.push_back(key);
  });
  const JsonObject object(document, token, path, keys, rotation_shape());
  std::string chosen;
  for (const std::string& candidate : keys) {
    if (!object.find(candidate)) continue;
    if (!chosen.empty()) {
      throw document.error(token, path, "both \"" + chosen + "\" and \"" + candidate + "\" are given",
                           "write exactly " + rotation_shape());
    }
    chosen = candidate;
  }
  if (chosen.empty()) {
    throw document.error(token, path, "the object is empty", "leave \"rotation\" out, or write " + rotation_shape());
  }
  const std::size_t value = object.get(chosen);
  const std::string value_path = object.path(chosen);
  Rotation read;
  for_each_form([&](auto form) {
    using Form = FormOf<decltype(form)>;
    if (chosen != Form::key) return;
    if (Form::polynomials.size() == 1) {
      for (const auto& only : Form::polynomials) form.*only.coefficients = read_polynomial(document, value, value_path);
    } else {
      std::vector<std::string> names;
      for (const auto& polynomial : Form::polynomials) names.emplace_back(polynomial.name);
      const JsonObject members(document, value, value_path, names, rotation_shape());
      for (const auto& polynomial : Form::polynomials) {
        form.*polynomial.coefficients =
            read_polynomial(document, members.get(polynomial.name), members.path(polynomial.name));
      }
    }
    read = std::move(form);
  });
  return read;
}

const char* const motion_shape = R"(a motion as {"x":[c0,c1,...],"y":[c0,...],"rotation":{"angle":[a0,a1,...]}})";
const std::vector<std::string> piece_keys = {"x", "y", "rotation", "until", "pivot", "origin", "orbit"};
const std::vector<std::string> form_keys = {"keyframes", "csv", "velocity", "spin_deg", "sweep"};

Point read_pair(const JsonDocument& document, std::size_t token, const std::string& path) {
  const std::string shape = "two numbers as [x, y]";
  const auto numbers = read_numbers(document, token, path, shape, 2, "write " + shape);
  if (numbers.size() == 2) return {numbers[0], numbers[1]};
  throw document.error(token, path, "expected two numbers, found " + std::to_string(numbers.size()), "write " + shape);
}

Point read_pivot(const JsonDocument& document, const JsonObject& object) {
  const auto pivot = object.find("pivot");
  return pivot ? read_pair(document, *pivot, object.path("pivot")) : Point{};
}

Orbit read_orbit(const JsonDocument& document, std::size_t token, const std::string& path) {
  const std::string shape = R"({"center": [x, y], "angle": [a0, a1, ...]})";
  const JsonObject object(document, token, path, {"center", "angle"}, shape);
  const auto centre = read_numbers(document, object.get("center"), object.path("center"), shape, 2, "write " + shape);
  if (centre.size() != 2)
    throw document.error(object.get("center"), object.path("center"), "expected two numbers", "write " + shape);
  return {{centre[0], centre[1]}, read_polynomial(document, object.get("angle"), object.path("angle"))};
}

MotionPiece read_piece(const JsonDocument& document, std::size_t token, const std::string& path) {
  const JsonObject object(document, token, path, piece_keys, motion_shape);
  MotionPiece piece;
  piece.pivot = read_pivot(document, object);
  if (const auto x = object.find("x")) piece.x = read_polynomial(document, *x, object.path("x"));
  if (const auto y = object.find("y")) piece.y = read_polynomial(document, *y, object.path("y"));
  if (const auto r = object.find("rotation")) piece.rotation = read_rotation(document, *r, object.path("rotation"));
  if (const auto origin = object.find("origin")) piece.origin = read_number(document, *origin, object.path("origin"));
  if (const auto orbit = object.find("orbit")) piece.orbit = read_orbit(document, *orbit, object.path("orbit"));
  if (const auto until = object.find("until")) piece.until = read_number(document, *until, object.path("until"));
  return piece;
}

/// Pieces must follow each other in time. Checked here as well as in validate(), because only here is the line known.
void require_ascending(const JsonDocument& document, std::size_t token, const std::string& path, const Motion& motion,
                       bool last) {
  const double until = motion.pieces.back().until;
  if (!last && until == std::numeric_limits<double>::infinity()) {
    throw document.error(token, path, "the key \"until\" is missing",
                         "only the last piece may leave out \"until\", the instant at which the next one takes over");
  }
  const std::size_t n = motion.pieces.size();
  if (n > 1 && !(motion.pieces[n - 2].until < until)) {
    throw document.error(token, path + ".until", "not later than \"until\" of the piece before",
                         "order the pieces by time; each must end after the one before");
  }
}

/// The forms of taut/motions.hpp, each of which is a whole motion.
class FormReader {
 public:
  FormReader(const JsonDocument& document, std::size_t token, const std::string& path, const JsonObject& object,
             const MotionContext& context)
      : document_(document), token_(token), path_(path), object_(object), context_(context) {}

  Motion read() const {
    const Point pivot = read_pivot(document_, object_);
    if (const auto keyframes = object_.find("keyframes")) {
      allow_only("keyframes", {"keyframes", "pivot"});
      return compiled(*keyframes, "keyframes", from_keyframes,
                      read_keyframes(document_, *keyframes, object_.path("keyframes"), context_.limits), pivot);
    }
    if (const auto file = object_.find("csv")) {
      allow_only("csv", {"csv", "pivot"});
      return compiled(*file, "csv", from_keyframes, read_csv(*file), pivot);
    }
    if (const auto sweep = object_.find("sweep")) {
      allow_only("sweep", {"sweep"});
      return read_sweep(*sweep);
    }
    allow_only(object_.find("velocity") ? "velocity" : "spin_deg", {"velocity", "spin_deg", "pivot"});
    return read_velocity(pivot);
  }

 private:
  /// What the function of taut/motions.hpp makes of its arguments; an error is said to be at `token`.
  template <class Function, class... Arguments>
  Motion compiled(std::size_t token, const char* key, Function function, const Arguments&... arguments) const {
    try {
      return function(arguments...);
    } catch (const InputError& e) {
      throw e.within(document_.error(token, object_.path(key), "", "").place());
    }
  }

  void allow_only(const std::string& form, const std::vector<std::string>& keys) const {
    for (const auto* group : {&form_keys, &piece_keys}) {
      for (const std::string& key : *group) {
        const auto value = object_.find(key);
        if (!value || std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        throw document_.error(
            token_, path_, "both \"" + form + "\" and \"" + key + "\" are given",
            "\"" + form + "\" describes a whole motion: leave out \"" + key + "\"" + remedy(form, key));
      }
    }
  }

  static std::string remedy(const std::string& form, const std::string& key) {
    if (form == "sweep" && key == "pivot") return R"(, and write the pivot as {"sweep":{"pivot":[x,y],...}})";
    return "";
  }

  std::vector<Keyframe> read_csv(std::size_t token) const {
    document_.require(token, JsonKind::string, object_.path("csv"), R"({"csv": "file.csv"})");
    try {
      const std::string& file = document_.string_at(token);
      return read_keyframes_csv(named_file(context_.folder, file, context_.limits.allow_outside), context_.limits);
    } catch (const InputError& e) {
      throw e.within(document_.error(token, object_.path("csv"), "", "").place());
    }
  }

  Motion read_velocity(const Point& pivot) const {
    const auto velocity = object_.find("velocity"), spin = object_.find("spin_deg");
    return from_velocity(velocity ? read_pair(document_, *velocity, object_.path("velocity")) : Point{},
                         spin ? read_number(document_, *spin, object_.path("spin_deg")) : 0, pivot);
  }

  Motion read_sweep(std::size_t token) const {
    const std::string here = object_.path("sweep");
    const JsonObject sweep(document_, token, here, {"pivot", "from_deg", "to_deg"},
                           R"({"sweep":{"pivot":[x,y],"from_deg":0,"to_deg":90}})");
    const double from = read_number(document_, sweep.get("from_deg"), sweep.path("from_deg"));
    const double to = read_number(document_, sweep.get("to_deg"), sweep.path("to_deg"));
    if (!(context_.start < context_.end)) {
      throw document_.error(token, here, "the scene's time interval has no length",
                            "give the sweep a time [start, end] with start < end, for instance that of its angles");
    }
    return compiled(token, "sweep", from_sweep, read_pivot(document_, sweep), from, to, context_.start, context_.end);
  }

  const JsonDocument& document_;
  std::size_t token_;
  std::string path_;
  const JsonObject& object_;
  const MotionContext& context_;
};

Motion read_object(const JsonDocument& document, std::size_t token, const std::string& path,
                   const MotionContext& context) {
  std::vector<std::string> keys = piece_keys;
  keys.insert(keys.end(), form_keys.begin(), form_keys.end());
  const JsonObject object(document, token, path, keys, motion_shape);
  const bool form = std::any_of(form_keys.begin(), form_keys.end(),
                                [&object](const std::string& key) { return object.find(key).has_value(); });
  if (form) return FormReader(document, token, path, object, context).read();
  return {{read_piece(document, token, path)}};
}

/// In an array only pieces may stand; whoever writes a whole motion there gets more than "unknown key".
void refuse_forms(const JsonDocument& document, std::size_t token, const std::string& path) {
  if (document.at(token).kind() != JsonKind::object) return;
  for (std::size_t key = token + 1; key < document.after(token); key = document.after(key + 1)) {
    const std::string& name = document.string_at(key);
    if (std::find(form_keys.begin(), form_keys.end(), name) == form_keys.end()) continue;
    throw document.error(key, path, "\"" + name + "\" describes a whole motion, not a piece of one",
                         "write it without the array, or write pieces with \"x\", \"y\" and \"rotation\"");
  }
}

}  // namespace

Motion read_motion(const JsonDocument& document, std::size_t token, const std::string& path,
                   const MotionContext& context) {
  Motion motion;
  if (document.at(token).kind() == JsonKind::null) return motion;
  if (document.at(token).kind() != JsonKind::array) return read_object(document, token, path, context);
  const std::size_t end = document.after(token);
  if (end == token + 1) {
    throw document.error(token, path, "no pieces", "leave \"motion\" out, or write null, for a body at rest");
  }
  for (std::size_t i = token + 1; i < end; i = document.after(i)) {
    const std::string here = element_path(path, motion.pieces.size());
    if (motion.pieces.size() == context.limits.max_pieces) {
      throw document.error(i, path, "more pieces than the limit of " + std::to_string(context.limits.max_pieces),
                           "split the scene in time, or raise ReadLimits::max_pieces");
    }
    refuse_forms(document, i, here);
    motion.pieces.push_back(read_piece(document, i, here));
    require_ascending(document, i, here, motion, document.after(i) == end);
  }
  return motion;
}

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
