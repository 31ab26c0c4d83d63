// The answer to whether bodies keep a clearance, as JSON.
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

std::string features_text(const Scene& scene, const CloseFeatures& features) {
  return ",\"vertex\":" + io::vertex_json(scene, features.vertex) +
         (features.edge ? ",\"edge\":" + io::edge_json(scene, *features.edge)
                        : ",\"other_vertex\":" + io::vertex_json(scene, *features.other));
}

/// The members of one pair's answer, without the braces.
std::string members_of(const Scene& scene, const PairMargin& pair) {
  std::string s =
      "\"bodies\":" + io::pair_names_json(scene, pair.bodies) + ",\"outcome\":\"" + to_string(pair.outcome) + "\"";
  if (pair.outcome == Outcome::contact) s += ",\"t\":" + io::array_text({pair.time.lo, pair.time.hi});
  if (pair.grazing) s += ",\"grazing\":true";
  if (pair.features) s += features_text(scene, *pair.features);
  if (pair.nearest) {
    const NearestPoints& n = *pair.nearest;
    s += ",\"distance\":" + io::number_text(n.hi) + ",\"points\":[" + io::point_text(n.points[0]) + "," +
         io::point_text(n.points[1]) + "],\"edges\":[" + io::edge_json(scene, n.edges[0]) + "," +
         io::edge_json(scene, n.edges[1]) + "]";
  }
  if (pair.outcome != Outcome::free) s += ",\"free_until\":" + io::number_text(pair.free_until);
  if (!pair.reason.empty()) s += ",\"reason\":" + io::string_text(pair.reason);
  return s;
}

std::string list_of(const Scene& scene, const std::vector<PairMargin>& pairs) {
  std::string s = "[";
  for (const PairMargin& pair : pairs) s += (s.size() > 1 ? ",{" : "{") + members_of(scene, pair) + "}";
  return s + "]";
}

}  // namespace

std::string io::proved_clearance_json(const Scene& scene, const Verified& proved) {
  std::string s = ",\"clearance\":" + number_text(proved.clearance);
  if (!proved.closer) return s;
  const TimeInterval& time = proved.closer->time;
  return s + ",\"closer\":{\"t\":" + array_text({time.lo, time.hi}) + features_text(scene, proved.closer->features) +
         "}";
}

std::string margin_json(const Scene& scene, double clearance, const MarginAnswer& answer, Touch touch) {
  std::string s = io::verdict_json(scene, to_string(answer.outcome)) + ",\"clearance\":" + io::number_text(clearance);
  if (answer.first) {
    const PairMargin& first = *answer.first;
    if (first.outcome == Outcome::contact) s += ",\"t\":" + io::array_text({first.time.lo, first.time.hi});
    s += ",\"pair\":" + io::pair_names_json(scene, first.bodies) + ",\"first\":{" + members_of(scene, first) + "}";
  }
  if (!answer.also.empty()) s += ",\"also\":" + list_of(scene, answer.also);
  if (!answer.pairs.empty()) s += ",\"pairs\":" + list_of(scene, answer.pairs);
  if (answer.outcome == Outcome::undecided) s += ",\"free_until\":" + io::number_text(answer.free_until);
  if (!answer.reason.empty()) s += ",\"reason\":" + io::string_text(answer.reason);
  s += io::geometry_json(answer.geometry);
  return s + io::coverage_json(answer.coverage) + ",\"scope\":{\"time\":" + io::array_text({scene.start, scene.end}) +
         ",\"touch\":\"" + to_string(touch) + "\"}}";
}

}  // namespace taut
