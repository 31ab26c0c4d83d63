#include "io/motion_reader.hpp"

#include <limits>

#include "io/json_numbers.hpp"
#include "io/json_object.hpp"

namespace taut::io {

namespace {

const char* const rotation_shape =
    R"(one of {"angle":[a0,a1,...]}, {"direction":{"a":[...],"b":[...]}}, {"half_angle_tangent":[...]}, {"cosine":[...]})";

Coefficients read_coefficients(const JsonDocument& document, std::size_t token, const std::string& path) {
  return read_numbers(document, token, path, "the coefficients in ascending powers of time, as [c0, c1, ...]",
                      max_degree + 1,
                      "the highest degree is " + std::to_string(max_degree) +
                          ": lower the degree, or split the motion into pieces with \"until\"");
}

Rotation read_rotation(const JsonDocument& document, std::size_t token, const std::string& path) {
  if (document.at(token).kind() == JsonKind::null) return NoRotation{};
  const std::vector<std::string> forms = {"angle", "direction", "half_angle_tangent", "cosine"};
  const JsonObject object(document, token, path, forms, rotation_shape);
  std::string form;
  for (const std::string& candidate : forms) {
    if (!object.find(candidate)) continue;
    if (!form.empty()) {
      throw document.error(token, path, "both \"" + form + "\" and \"" + candidate + "\" are given",
                           std::string("write exactly ") + rotation_shape);
    }
    form = candidate;
  }
  if (form.empty()) {
    throw document.error(token, path, "the object is empty",
                         std::string("leave \"rotation\" out, or write ") + rotation_shape);
  }
  const std::size_t value = object.get(form);
  const std::string value_path = object.path(form);
  if (form == "direction") {
    const JsonObject ab(document, value, value_path, {"a", "b"}, R"({"direction":{"a":[...],"b":[...]}})");
    return DirectionRotation{read_coefficients(document, ab.get("a"), ab.path("a")),
                             read_coefficients(document, ab.get("b"), ab.path("b"))};
  }
  Coefficients c = read_coefficients(document, value, value_path);
  if (form == "angle") return AngleRotation{std::move(c)};
  if (form == "cosine") return CosineRotation{std::move(c)};
  return HalfAngleRotation{std::move(c)};
}

MotionPiece read_piece(const JsonDocument& document, std::size_t token, const std::string& path) {
  const JsonObject object(document, token, path, {"x", "y", "rotation", "until"},
                          R"(a motion as {"x":[c0,c1,...],"y":[c0,...],"rotation":{"angle":[a0,a1,...]}})");
  MotionPiece piece;
  if (const auto x = object.find("x")) piece.x = read_coefficients(document, *x, object.path("x"));
  if (const auto y = object.find("y")) piece.y = read_coefficients(document, *y, object.path("y"));
  if (const auto r = object.find("rotation")) piece.rotation = read_rotation(document, *r, object.path("rotation"));
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

}  // namespace

Motion read_motion(const JsonDocument& document, std::size_t token, const std::string& path, std::size_t max_pieces) {
  Motion motion;
  if (document.at(token).kind() == JsonKind::null) return motion;
  if (document.at(token).kind() != JsonKind::array) {
    motion.pieces.push_back(read_piece(document, token, path));
    return motion;
  }
  const std::size_t end = document.after(token);
  if (end == token + 1) {
    throw document.error(token, path, "no pieces", "leave \"motion\" out, or write null, for a body at rest");
  }
  for (std::size_t i = token + 1; i < end; i = document.after(i)) {
    const std::string here = element_path(path, motion.pieces.size());
    if (motion.pieces.size() == max_pieces) {
      throw document.error(i, path, "more pieces than the limit of " + std::to_string(max_pieces),
                           "split the scene in time, or raise ReadLimits::max_pieces");
    }
    motion.pieces.push_back(read_piece(document, i, here));
    require_ascending(document, i, here, motion, document.after(i) == end);
  }
  return motion;
}

}  // namespace taut::io
