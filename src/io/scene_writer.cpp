#include <algorithm>
#include <cmath>
#include <limits>

#include "io/json_writer.hpp"
#include "motion/rotation_forms.hpp"
#include "scene/mechanism_lock.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"

namespace taut {
using namespace internal;

namespace {

/// Empty for what is not written.
std::string rotation_text(const Rotation& rotation) {
  return std::visit(
      [](const auto& form) {
        using Form = FormOf<decltype(form)>;
        std::string inner;
        for (const auto& polynomial : Form::polynomials) {
          const std::string text = io::array_text(form.*polynomial.coefficients);
          if (Form::polynomials.size() == 1)
            inner = text;
          else
            inner += (inner.empty() ? "{\"" : ",\"") + std::string(polynomial.name) + "\":" + text;
        }
        if (inner.empty()) return inner;
        return "{\"" + std::string(Form::key) + "\":" + inner + (Form::polynomials.size() == 1 ? "}" : "}}");
      },
      rotation);
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
  if (!piece.orbit.angle.empty()) {
    const std::string centre = io::point_text(piece.orbit.centre);
    member("orbit", "{\"center\":" + centre + ",\"angle\":" + io::array_text(piece.orbit.angle) + "}");
  }
  if (piece.origin != 0) member("origin", io::number_text(piece.origin));
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

std::string polygon_text(const Polygon& polygon) {
  std::string s = "[";
  const char* separator = "";
  for (const Point& p : polygon) {
    s += separator + io::point_text(p);
    separator = ",";
  }
  return s + "]";
}

std::string layers_text(const Layers& z) {
  const auto end = [](double height) { return std::isfinite(height) ? io::number_text(height) : "null"; };
  return "\"z\":[" + end(z.lo) + "," + end(z.hi) + "]";
}

std::string part_text(const Part& part) {
  if (part.holes.empty() && !part.z) return polygon_text(part.outline);
  std::string s = "{\"outline\":" + polygon_text(part.outline);
  const char* separator = ",\n    \"holes\":[";
  for (const Polygon& hole : part.holes) {
    s += separator + polygon_text(hole);
    separator = ",\n     ";
  }
  if (!part.holes.empty()) s += "]";
  if (part.z) s += ",\n    " + layers_text(*part.z);
  return s + "}";
}

std::string parts_text(const std::vector<Part>& parts) {
  std::string s = "[";
  for (const Part& part : parts) s += (s.size() > 1 ? ",\n    " : "") + part_text(part);
  return s + "]";
}

std::string path_text(const std::vector<CurvedPart>& parts) {
  std::string s = "{\"path\":" + io::string_text(write_path(parts)) + ",\"fill-rule\":\"evenodd\"";
  if (parts[0].z) s += "," + layers_text(*parts[0].z);
  return s + "}";
}

/// Each part is a path of its own, since parts may overlap.
std::string curves_text(const std::vector<CurvedPart>& parts) {
  if (parts.size() == 1) return "\"polygon\":" + path_text(parts);
  std::string s = "\"parts\":[";
  for (std::size_t i = 0; i < parts.size(); ++i) s += (i ? ",\n    " : "") + path_text({parts[i]});
  return s + "]";
}

std::string joint_text(const std::vector<MechanismJoint>& joints, std::size_t first) {
  const bool slides = joints[first].kind == MechanismJoint::Kind::slide;
  std::string bodies = io::string_text(joints[first].first);
  for (std::size_t k = first; k < joints.size() && joints[k].name == joints[first].name; ++k)
    bodies += "," + io::string_text(joints[k].second);
  return io::string_text(joints[first].name) + ":{" + (slides ? "\"slide\":[" : "\"revolute\":[") + bodies + "]," +
         (slides ? "\"direction\":" + io::point_text(joints[first].direction)
                 : "\"at\":" + io::point_text(joints[first].at)) +
         "}";
}

bool is_slide(const Mechanism& mechanism, const std::string& joint) {
  for (const MechanismJoint& other : mechanism.joints) {
    if (other.name == joint) return other.kind == MechanismJoint::Kind::slide;
  }
  return false;
}

/// Lines as keyframes, which are in the scene's time, whatever that is.
std::string drive_text(const Mechanism& mechanism, const Drive& drive) {
  const std::string value = is_slide(mechanism, drive.joint) ? "\"value\":" : "\"deg\":";
  const Drive::Piece& piece = drive.pieces.front();
  if (!piece.line) return "{" + value + io::array_text(piece.polynomial) + "}";
  std::string s;
  const auto add = [&](double t, double v) {
    s += (s.empty() ? "[{\"t\":" : ",{\"t\":") + io::number_text(t) + "," + value + io::number_text(v) + "}";
  };
  const auto& first = *piece.line;
  add(first[0], first[1]);
  for (const Drive::Piece& next : drive.pieces) {
    if (next.line && (*next.line)[2] > (*next.line)[0]) add((*next.line)[2], (*next.line)[3]);
  }
  return s + "]";
}

std::string mechanism_text(const Mechanism& mechanism) {
  std::string s = "{\"ground\":" + io::string_text(mechanism.ground) + ",\n  \"joints\":{";
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    if (k > 0 && mechanism.joints[k].name == mechanism.joints[k - 1].name) continue;
    s += (k > 0 ? ",\n   " : "\n   ") + joint_text(mechanism.joints, k);
  }
  s += "},\n  \"drive\":{";
  for (const Drive& drive : mechanism.drives)
    s += (&drive == &mechanism.drives.front() ? "" : ",") + io::string_text(drive.joint) + ":" +
         drive_text(mechanism, drive);
  s += "}";
  for (const Coupling& coupling : mechanism.couplings)
    s += (&coupling == &mechanism.couplings.front() ? ",\n  \"couple\":[" : ",") + std::string("{\"joint\":") +
         io::string_text(coupling.joint) + ",\"to\":" + io::string_text(coupling.to) +
         ",\"times\":" + io::number_text(coupling.times) + "}";
  return s + (mechanism.couplings.empty() ? "}" : "]}");
}

/// Does a joint of the mechanism say how the body moves?
bool is_joined(const Scene& scene, const Body& body) {
  if (!scene.mechanism) return false;
  return std::any_of(scene.mechanism->joints.begin(), scene.mechanism->joints.end(), [&](const MechanismJoint& joint) {
    return joint.first == body.name || joint.second == body.name;
  });
}

std::string body_text(const Scene& scene, const Body& body) {
  std::string s = "  {\"name\":" + io::string_text(body.name);
  if (!body.curves.empty())
    s += ",\n   " + curves_text(body.curves);
  else if (body.parts.empty())
    s += ",\n   \"polygon\":" + polygon_text(polygon_of(body));
  else if (body.parts.size() == 1)
    s += ",\n   \"polygon\":" + part_text(body.parts[0]);
  else
    s += ",\n   \"parts\":" + parts_text(body.parts);
  if (!(body.z == Layers{})) s += ",\n   " + layers_text(body.z);
  const bool joined = is_joined(scene, body);
  if (!body.relative_to.empty() && !joined) s += ",\n   \"relative_to\":" + io::string_text(body.relative_to);
  s += ",\n   \"motion\":" + (joined ? "null" : motion_text(body.motion));
  if (!body.id.empty()) s += ",\n   \"id\":" + body.id;
  return s + "}";
}

std::string ignored_text(const Scene& scene) {
  std::string s;
  for (const auto& pair : scene.ignore)
    s += (s.empty() ? "[" : ",[") + io::string_text(pair[0]) + "," + io::string_text(pair[1]) + "]";
  return "[" + s + "]";
}

}  // namespace

std::string write_scene(const Scene& scene) {
  std::string s = "{\"format\":\"taut-scene/1\",\n \"time\":" + io::array_text({scene.start, given_end(scene)}) +
                  ",\n \"bodies\":[\n";
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) s += (i ? ",\n" : "") + body_text(scene, scene.bodies[i]);
  s += "\n ]";
  if (!scene.ignore.empty()) s += ",\n \"ignore\":" + ignored_text(scene);
  if (!scene.clearances.empty()) s += ",\n \"clearances\":" + io::clearances_text(scene.clearances);
  if (scene.mechanism) s += ",\n \"mechanism\":" + mechanism_text(*scene.mechanism);
  if (scene.at_rest == AtRest::test) s += ",\n \"at_rest\":\"test\"";
  if (!scene.id.empty()) s += ",\n \"id\":" + scene.id;
  return s + "}\n";
}

}  // namespace taut
