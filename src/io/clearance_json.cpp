// The answer to how close bodies come, as JSON.
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {
using namespace internal;
namespace {

std::string nearest_text(const Scene& scene, const NearestPoints& n) {
  std::string s = "{\"lo\":" + io::number_text(n.lo) + ",\"hi\":" + io::number_text(n.hi) +
                  ",\"t\":" + io::array_text({n.time.lo, n.time.hi}) +
                  ",\"pair\":" + io::pair_names_json(scene, n.pair);
  for (const BodyId id : n.pair) {
    const auto angle = angle_at(scene.bodies[static_cast<std::size_t>(id)].motion, n.time);
    if (!angle) continue;
    s += ",\"angle_deg\":" + io::array_text({angle->lo, angle->hi});
    break;
  }
  if (!(n.hi > 0)) return s + "}";
  return s + ",\"points\":[" + io::point_text(n.points[0]) + "," + io::point_text(n.points[1]) + "],\"edges\":[" +
         io::edge_json(scene, n.edges[0]) + "," + io::edge_json(scene, n.edges[1]) + "]}";
}

}  // namespace

std::string clearance_json(const Scene& scene, const Clearance& answer) {
  std::string s = io::verdict_json(scene, to_string(answer.outcome));
  s += ",\"clearance\":" + (answer.nearest ? nearest_text(scene, *answer.nearest) : std::string("null"));
  if (!answer.pairs.empty()) {
    s += ",\"pairs\":[";
    for (std::size_t i = 0; i < answer.pairs.size(); ++i) s += (i ? "," : "") + nearest_text(scene, answer.pairs[i]);
    s += "]";
  }
  if (!answer.reason.empty()) s += ",\"reason\":" + io::string_text(answer.reason);
  if (!answer.wide.empty()) s += ",\"wide\":" + io::string_text(answer.wide);
  s += io::geometry_json(answer.geometry);
  return s + io::coverage_json(answer.coverage) + ",\"scope\":{\"time\":" + io::array_text({scene.start, scene.end}) +
         "}}";
}

}  // namespace taut
