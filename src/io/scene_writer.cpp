#include <limits>

#include "io/json_text.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"

namespace taut {

namespace {

std::string rotation_text(const Rotation& rotation) {
  if (const auto* r = std::get_if<AngleRotation>(&rotation)) return "{\"angle\":" + io::array_text(r->angle) + "}";
  if (const auto* r = std::get_if<DirectionRotation>(&rotation)) {
    return "{\"direction\":{\"a\":" + io::array_text(r->a) + ",\"b\":" + io::array_text(r->b) + "}}";
  }
  if (const auto* r = std::get_if<HalfAngleRotation>(&rotation)) {
    return "{\"half_angle_tangent\":" + io::array_text(r->s) + "}";
  }
  if (const auto* r = std::get_if<CosineRotation>(&rotation)) return "{\"cosine\":" + io::array_text(r->a) + "}";
  return "";
}

std::string piece_text(const MotionPiece& piece) {
  std::string s;
  const auto member = [&s](const char* key, const std::string& value) {
    s += (s.empty() ? "\"" : ",\"") + std::string(key) + "\":" + value;
  };
  if (!piece.x.empty()) member("x", io::array_text(piece.x));
  if (!piece.y.empty()) member("y", io::array_text(piece.y));
  const std::string rotation = rotation_text(piece.rotation);
  if (!rotation.empty()) member("rotation", rotation);
  if (piece.pivot != Point{}) member("pivot", io::point_text(piece.pivot));
  if (piece.until != std::numeric_limits<double>::infinity()) member("until", io::number_text(piece.until));
  return "{" + s + "}";
}

std::string motion_text(const Motion& motion) {
  if (motion.pieces.empty()) return "null";
  if (motion.pieces.size() == 1) return piece_text(motion.pieces[0]);
  std::string s = "[";
  for (const MotionPiece& piece : motion.pieces) s += (s.size() > 1 ? ",\n    " : "") + piece_text(piece);
  return s + "]";
}

std::string body_text(const Body& body) {
  std::string s = "  {\"name\":" + io::string_text(body.name) + ",\n   \"polygon\":[";
  const char* separator = "";
  for (const Point& p : polygon_of(body)) {
    s += separator + io::point_text(p);
    separator = ",";
  }
  s += "],\n   \"motion\":" + motion_text(body.motion);
  if (!body.id.empty()) s += ",\n   \"id\":" + body.id;
  return s + "}";
}

}  // namespace

std::string write_scene(const Scene& scene) {
  std::string s =
      "{\"format\":\"taut-scene/1\",\n \"time\":" + io::array_text({scene.start, scene.end}) + ",\n \"bodies\":[\n";
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) s += (i ? ",\n" : "") + body_text(scene.bodies[i]);
  s += "\n ]";
  if (!scene.id.empty()) s += ",\n \"id\":" + scene.id;
  return s + "}\n";
}

}  // namespace taut
