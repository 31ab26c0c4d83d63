// The answer to how bodies come apart, as JSON.
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

template <class Items, class Text>
std::string listed(const Items& items, const Text& text) {
  std::string s = "[";
  for (const auto& item : items) s += (s.size() > 1 ? "," : "") + text(item);
  return s + "]";
}

std::string name_text(const Scene& scene, BodyId id) {
  return io::string_text(scene.bodies[static_cast<std::size_t>(id)].name);
}

std::string arc_text(const Scene& scene, const DirectionArc& arc) {
  const auto vertices = [&](const char* key, const std::optional<std::array<VertexRef, 2>>& pair) {
    if (!pair) return std::string();
    return ",\"" + std::string(key) + "\":[" + io::vertex_json(scene, (*pair)[0]) + "," +
           io::vertex_json(scene, (*pair)[1]) + "]";
  };
  const auto reach = [&](const char* key, const std::optional<VertexAtEdge>& at) {
    if (!at) return std::string();
    return ",\"" + std::string(key) + "\":{\"vertex\":" + io::vertex_json(scene, at->vertex) +
           ",\"edge\":" + io::edge_json(scene, at->edge) + "}";
  };
  return "{\"from_deg\":" + io::array_text({arc.from.lo, arc.from.hi}) +
         ",\"to_deg\":" + io::array_text({arc.to.lo, arc.to.hi}) + ",\"point\":" + (arc.point ? "true" : "false") +
         vertices("from_vertices", arc.from_vertices) + vertices("to_vertices", arc.to_vertices) +
         reach("from_reach", arc.from_reach) + reach("to_reach", arc.to_reach) + "}";
}

std::string arcs_text(const Scene& scene, const BodyDirections& body) {
  return "\"all\":" + std::string(body.all ? "true" : "false") +
         ",\"directions\":" + listed(body.free, [&](const DirectionArc& arc) { return arc_text(scene, arc); });
}

std::string step_text(const Scene& scene, const RemovalStep& step) {
  return "{\"body\":" + name_text(scene, step.body) + ",\"direction_deg\":" + io::number_text(step.direction_deg) +
         ",\"within\":" + arc_text(scene, step.free) + "}";
}

}  // namespace

std::string separation_json(const Scene& scene, const Separation& answer) {
  std::string s = io::verdict_json(scene, to_string(answer.outcome));
  if (!answer.reason.empty()) s += ",\"reason\":" + io::string_text(answer.reason);
  if (answer.overlap) s += ",\"pair\":" + io::pair_names_json(scene, *answer.overlap);
  if (scene.bodies.size() == 2) {
    const BodyDirections second = answer.bodies.empty() ? BodyDirections{1, {}, false} : answer.bodies[0];
    s += ",\"body\":" + name_text(scene, second.body) + "," + arcs_text(scene, second);
  } else {
    s += ",\"bodies\":" + listed(answer.bodies, [&](const BodyDirections& body) {
           return "{\"body\":" + name_text(scene, body.body) + "," + arcs_text(scene, body) + "}";
         });
    s += ",\"order\":" + listed(answer.order, [&](const RemovalStep& step) { return step_text(scene, step); });
    s += ",\"stuck\":" + listed(answer.stuck, [&](BodyId id) { return name_text(scene, id); });
  }
  return s + io::geometry_json(answer.geometry) + io::coverage_json(answer.coverage) + "}";
}

}  // namespace taut
