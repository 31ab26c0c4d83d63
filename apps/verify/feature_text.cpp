#include "feature_text.hpp"

#include <fmt/format.h>

#include "taut/shape.hpp"

namespace taut::cli {
namespace {

/// Which ring of a body of several.
template <class Ref>
std::string ring_text(const Body& body, const Ref& feature) {
  std::string text;
  if (feature.ring > 0) text += fmt::format("hole {} of ", feature.ring);
  if (body.parts.size() > 1 || body.curves.size() > 1) text += fmt::format("part {} of ", feature.part);
  return text + body.name;
}

/// Of a body that is bounded by curves.
template <class Ref>
std::string curve_text(const Body& body, const Ref& feature) {
  return fmt::format("segment {} (at {:.6g}) of {}", feature.index, *feature.parameter, ring_text(body, feature));
}

std::size_t ring_size(const Body& body, const EdgeRef& edge) {
  if (body.parts.empty()) return polygon_of(body).size();
  const Part& part = body.parts[static_cast<std::size_t>(edge.part)];
  return edge.ring == 0 ? part.outline.size() : part.holes[static_cast<std::size_t>(edge.ring - 1)].size();
}

}  // namespace

std::string vertex_text(const Scene& scene, const VertexRef& vertex) {
  const Body& body = scene.bodies[static_cast<std::size_t>(vertex.body)];
  if (vertex.parameter) return curve_text(body, vertex);
  return fmt::format("vertex {} of {}", vertex.index, ring_text(body, vertex));
}

std::string edge_text(const Scene& scene, const EdgeRef& edge) {
  const Body& body = scene.bodies[static_cast<std::size_t>(edge.body)];
  if (edge.parameter) return curve_text(body, edge);
  const std::size_t next = (static_cast<std::size_t>(edge.index) + 1) % ring_size(body, edge);
  return fmt::format("edge {}-{} of {}", edge.index, next, ring_text(body, edge));
}

std::string subject_text(const Scene& scene, const std::optional<std::array<BodyId, 2>>& pair) {
  const auto name = [&](BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; };
  if (pair) return name((*pair)[0]) + " x " + name((*pair)[1]);
  if (scene.bodies.size() == 2) return name(0) + " x " + name(1);
  if (scene.bodies.size() == 1) return name(0);
  return fmt::format("{} bodies", scene.bodies.size());
}

}  // namespace taut::cli
