#include "io/answer_json.hpp"

#include "io/json_text.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;

namespace {

/// A vertex or an edge. Part and ring are left out where the body has but one of each.
template <class Ref>
std::string feature_text(const Scene& scene, const Ref& feature) {
  const Body& body = scene.bodies[static_cast<std::size_t>(feature.body)];
  std::string s = "{\"body\":" + io::string_text(body.name);
  if (!body.id.empty()) s += ",\"id\":" + body.id;
  if (feature.parameter)
    return s + io::curve_place_json(body, feature.part, feature.ring, feature.index, *feature.parameter) + "}";
  if (!body.parts.empty())
    s += ",\"part\":" + std::to_string(feature.part) + ",\"ring\":" + std::to_string(feature.ring);
  return s + ",\"index\":" + std::to_string(feature.index) + "}";
}

}  // namespace

std::string io::curve_place_json(const Body& body, int part, int ring, int segment, double parameter) {
  std::string s;
  if (body.curves.size() > 1 || (!body.curves.empty() && !body.curves[0].holes.empty()))
    s += ",\"part\":" + std::to_string(part) + ",\"ring\":" + std::to_string(ring);
  return s + ",\"index\":" + std::to_string(segment) + ",\"at\":" + io::number_text(parameter);
}

std::string io::geometry_json(const std::optional<CurveGeometry>& geometry) {
  if (!geometry) return "";
  return ",\"geometry\":{\"tolerance\":" + io::number_text(geometry->tolerance) +
         ",\"segments\":" + std::to_string(geometry->segments) + "}";
}

std::string io::pair_names_json(const Scene& scene, const std::array<BodyId, 2>& pair) {
  return "[" + io::string_text(scene.bodies[static_cast<std::size_t>(pair[0])].name) + "," +
         io::string_text(scene.bodies[static_cast<std::size_t>(pair[1])].name) + "]";
}

std::string io::pair_answer_json(const Scene& scene, const PairAnswer& pair) {
  std::string s =
      "{\"bodies\":" + io::pair_names_json(scene, pair.bodies) + ",\"outcome\":\"" + to_string(pair.outcome) + "\"";
  if (pair.contact) s += io::contact_json(scene, *pair.contact);
  if (pair.outcome == Outcome::undecided)
    s += ",\"free_until\":" + io::number_text(pair.free_until) + ",\"reason\":" + io::string_text(pair.reason);
  return s + "}";
}

std::string io::coverage_json(const Coverage& c) {
  return ",\"coverage\":{\"pairs\":" + std::to_string(c.pairs) + ",\"tested\":" + std::to_string(c.tested) +
         ",\"apart\":" + std::to_string(c.apart) + ",\"ignored\":" + std::to_string(c.ignored) +
         ",\"moving_alike\":" + std::to_string(c.moving_alike) + ",\"at_rest\":" + std::to_string(c.at_rest) + "}";
}

std::string io::verdict_json(const Scene& scene, const char* outcome) {
  return (scene.id.empty() ? "{" : "{\"id\":" + scene.id + ",") + "\"outcome\":\"" + outcome + "\"";
}

std::string io::vertex_json(const Scene& scene, const VertexRef& vertex) { return feature_text(scene, vertex); }
std::string io::edge_json(const Scene& scene, const EdgeRef& edge) { return feature_text(scene, edge); }

std::string io::features_json(const Scene& scene, const Contact& contact) {
  return "{\"vertex\":" + feature_text(scene, contact.vertex) + ",\"edge\":" + feature_text(scene, contact.edge) +
         ",\"point\":" + io::point_text(contact.point) + (contact.grazing ? ",\"grazing\":true}" : "}");
}

namespace {

std::string pairs_text(const Scene& scene, const char* key, const std::vector<PairAnswer>& pairs) {
  std::string s = std::string(",\"") + key + "\":[";
  for (std::size_t i = 0; i < pairs.size(); ++i) s += (i ? "," : "") + io::pair_answer_json(scene, pairs[i]);
  return s + "]";
}

/// Which pairs the answer is about.
std::string about_pairs(const Scene& scene, const Answer& answer) {
  std::string s;
  if (answer.pair) s += ",\"pair\":" + io::pair_names_json(scene, *answer.pair);
  if (!answer.also.empty()) s += pairs_text(scene, "also", answer.also);
  s += io::coverage_json(answer.coverage);
  if (answer.pairs) s += pairs_text(scene, "pairs", *answer.pairs);
  return s;
}

/// Of a sweep.
std::string angle_text(const Scene& scene, const Contact& contact) {
  const auto angle = contact_angle(scene, contact);
  return angle ? ",\"angle_deg\":" + io::array_text({angle->lo, angle->hi}) : "";
}

std::string scope_text(const Scene& scene, Touch touch, double fit) {
  std::string s = "{\"bodies\":[";
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) s += (i ? "," : "") + io::string_text(scene.bodies[i].name);
  return s + "],\"time\":" + io::array_text({scene.start, scene.end}) + ",\"touch\":\"" + to_string(touch) + "\"" +
         (fit > 0 ? ",\"fit\":" + io::number_text(fit) : std::string()) +
         (scene.at_rest == AtRest::test ? ",\"at_rest\":\"test\"" : "") + "}";
}

}  // namespace

std::string io::contact_json(const Scene& scene, const Contact& contact) {
  return ",\"t\":" + io::array_text({contact.time.lo, contact.time.hi}) + (contact.grazing ? ",\"grazing\":true" : "") +
         ",\"contact\":{\"vertex\":" + feature_text(scene, contact.vertex) +
         ",\"edge\":" + feature_text(scene, contact.edge) + ",\"point\":" + io::point_text(contact.point) +
         ",\"normal\":" + io::point_text(contact.normal) + angle_text(scene, contact) + "}";
}

}  // namespace taut

namespace taut::internal {

std::string answer_json(const Scene& scene, const Answer& answer, Touch touch,
                        const std::optional<AnswerTiming>& timing) {
  std::string s = io::verdict_json(scene, to_string(answer.outcome));
  if (answer.contact) s += io::contact_json(scene, *answer.contact);
  if (answer.touching)
    s += ",\"grazing\":true,\"touching\":{" + io::contact_json(scene, *answer.touching).substr(1) + "}";
  if (!answer.touching_undecided.empty()) s += ",\"touching_undecided\":" + io::string_text(answer.touching_undecided);
  if (answer.overlap_point) s += ",\"overlap\":{\"point\":" + io::point_text(*answer.overlap_point) + "}";
  if (answer.outcome == Outcome::undecided) s += ",\"free_until\":" + io::number_text(answer.free_until);
  if (!answer.reason.empty()) s += ",\"reason\":" + io::string_text(answer.reason);
  s += about_pairs(scene, answer);
  s += io::geometry_json(answer.geometry);
  s += std::string(",\"engine\":\"") + (answer.compared ? "both" : to_string(answer.engine)) +
       "\",\"events\":" + std::to_string(answer.events) +
       ",\"certificates\":{\"initial\":" + std::to_string(answer.certificates_initial) +
       ",\"max\":" + std::to_string(answer.certificates_max) + "},\"scope\":" + scope_text(scene, touch, answer.fit);
  if (timing) {
    s += ",\"timing\":{\"read\":" + io::number_text(timing->read) + ",\"build\":" + io::number_text(timing->build) +
         ",\"run\":" + io::number_text(timing->run) + "}";
  }
  return s + "}";
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string answer_json(const Scene& scene, const Answer& answer, Touch touch) {
  return answer_json(scene, answer, touch, std::nullopt);
}

}  // namespace taut
