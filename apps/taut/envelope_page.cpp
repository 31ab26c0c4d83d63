#include "envelope_page.hpp"

#include <algorithm>

#include "draw/world_shapes.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "scene/linkage.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"
#include "viewer_page.hpp"

namespace taut::cli {
using namespace internal;
namespace {

std::string coordinates_text(const Point& p) { return io::array_text({p.x, p.y}); }

std::string outline_text(const Polygon& ring) {
  std::string s = "[";
  for (const Point& p : ring) s += (s.size() > 1 ? "," : "") + coordinates_text(p);
  return s + "]";
}

std::string part_text(const Polygon& outline, const std::vector<Polygon>& holes) {
  std::string s = "[" + outline_text(outline);
  for (const Polygon& hole : holes) s += "," + outline_text(hole);
  return s + "]";
}

std::string parts_text(const Body& body) {
  if (body.parts.empty()) return "[" + part_text(polygon_of(body), {}) + "]";
  std::string s = "[";
  for (const Part& part : body.parts) s += (s.size() > 1 ? "," : "") + part_text(part.outline, part.holes);
  return s + "]";
}

std::string single_text(const JointMotion& motion) {
  const auto* revolute = std::get_if<Revolute>(&motion.kind);
  return "{\"joint\":" + std::to_string(motion.joint) + ",\"times\":" + io::number_text(motion.times) +
         ",\"plus\":" + io::number_text(motion.plus) +
         (revolute ? ",\"pivot\":" + coordinates_text(revolute->pivot)
                   : ",\"direction\":" + coordinates_text(std::get<Slide>(motion.kind).direction)) +
         "}";
}

/// Revolutes and slides, the outermost first.
std::string motion_text(const JointMotion& motion) {
  std::string s = "[";
  for (const JointMotion& single : single_motions(motion)) s += (s.size() > 1 ? "," : "") + single_text(single);
  return s + "]";
}

std::string body_text(const Linkage& linkage, std::size_t k) {
  const std::vector<Body>& bodies = linkage.scene.bodies;
  std::string s = "{\"name\":" + io::string_text(bodies[k].name) + ",\"parts\":" + parts_text(bodies[k]);
  const auto parent =
      std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) { return body.name == bodies[k].relative_to; });
  if (!bodies[k].relative_to.empty() && parent != bodies.end())
    s += ",\"parent\":" + std::to_string(parent - bodies.begin());
  if (k < linkage.motions.size() && linkage.motions[k]) s += ",\"motion\":" + motion_text(*linkage.motions[k]);
  return s + "}";
}

std::string page_text(const Linkage& linkage, const Envelope& answer, const EnvelopePageOptions& options) {
  std::string s = "{" + (options.title.empty() ? std::string() : "\"title\":" + io::string_text(options.title) + ",");
  s += "\"envelope\":" + envelope_json(linkage, answer, options.tolerance, true) + ",\"bodies\":[";
  for (std::size_t k = 0; k < linkage.scene.bodies.size(); ++k) s += (k ? "," : "") + body_text(linkage, k);
  s += "],\"colours\":[";
  for (std::size_t k = 0; k < io::body_styles; ++k) s += (k ? "," : "") + io::string_text(io::body_style(k).fill);
  return s + "]}";
}

}  // namespace

void write_envelope_page(const Linkage& linkage, const Envelope& answer, const EnvelopePageOptions& options,
                         const std::string& output) {
  write_page("envelope.html", options.template_path, page_text(linkage, answer, options), output);
}

}  // namespace taut::cli
