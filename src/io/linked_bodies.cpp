#include "io/linked_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "io/json_writer.hpp"
#include "io/number_text.hpp"
#include "scene/linkage.hpp"
#include "taut/shape.hpp"

namespace taut::internal::io {
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

/// The values of a link's joint, evenly over the range of the joint that drives it.
std::string link_motion_json(const LinkMotion& link, int joint, const Joint& driven) {
  constexpr int count = 513;
  std::vector<double> values;
  for (int k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / (count - 1);
    values.push_back(link.follows.sign * value_of_link(link, driven.lo + share * (driven.hi - driven.lo)));
  }
  const Point& d = link.follows.direction;
  const double length = std::hypot(d.x, d.y);
  return "{\"joint\":" + std::to_string(joint) + ",\"values\":" + array_text(values) +
         (link.follows.slides ? ",\"direction\":" + coordinates({d.x / length, d.y / length})
                              : ",\"pivot\":" + coordinates(link.pivot)) +
         "}";
}

std::string single_motion_json(const Linkage& linkage, const JointMotion& motion) {
  if (const auto* link = std::get_if<LinkMotion>(&motion.kind))
    return link_motion_json(*link, motion.joint, linkage.joints[static_cast<std::size_t>(motion.joint)]);
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
