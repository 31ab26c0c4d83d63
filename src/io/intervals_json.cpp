// The answers to questions of when, and how far, as JSON.
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {
using namespace internal;
namespace {

std::string interval_text(const TimeInterval& t) { return io::array_text({t.lo, t.hi}); }

/// The angle of the body of the pair that sweeps, if one does.
std::string degrees_text(const Scene& scene, const std::array<BodyId, 2>& pair, const char* key,
                         const TimeInterval& t) {
  for (const BodyId id : pair) {
    const auto angle = angle_at(scene.bodies[static_cast<std::size_t>(id)].motion, t);
    if (angle) return std::string(",\"") + key + "\":" + io::array_text({angle->lo, angle->hi});
  }
  return "";
}

std::string question_scope(const Scene& scene, Touch touch) {
  return ",\"scope\":{\"time\":" + io::array_text({scene.start, scene.end}) + ",\"touch\":\"" + to_string(touch) +
         "\"}";
}

std::string overlap_text(const Scene& scene, const OverlapInterval& o) {
  std::string s = "{\"pair\":" + io::pair_names_json(scene, o.pair) + ",\"from\":" + interval_text(o.from) +
                  ",\"to\":" + interval_text(o.to) + degrees_text(scene, o.pair, "from_deg", o.from) +
                  degrees_text(scene, o.pair, "to_deg", o.to);
  if (o.enter) s += ",\"enter\":" + io::features_json(scene, *o.enter);
  if (o.exit) s += ",\"exit\":" + io::features_json(scene, *o.exit);
  return s + "}";
}

/// The member "reason" with a comma before it, if there is one.
std::string reason_text(const std::string& reason) {
  return reason.empty() ? "" : ",\"reason\":" + io::string_text(reason);
}

}  // namespace

std::string intervals_json(const Scene& scene, const Intervals& answer, Touch touch) {
  std::string s = io::verdict_json(scene, to_string(answer.outcome)) + reason_text(answer.reason) + ",\"intervals\":[";
  for (std::size_t i = 0; i < answer.intervals.size(); ++i)
    s += (i ? "," : "") + overlap_text(scene, answer.intervals[i]);
  s += "],\"undecided\":[";
  for (std::size_t i = 0; i < answer.undecided.size(); ++i)
    s += (i ? "," : "") + io::pair_answer_json(scene, answer.undecided[i]);
  s += "]" + io::geometry_json(answer.geometry);
  return s + io::coverage_json(answer.coverage) + question_scope(scene, touch) + "}";
}

namespace {

std::string range_text(const Scene& scene, const Range& answer) {
  if (answer.outcome != Outcome::free) return "null";
  const auto end = [](const std::optional<TimeInterval>& t) { return t ? interval_text(*t) : std::string("null"); };
  std::string s = "{\"from\":" + end(answer.from) + ",\"to\":" + end(answer.to);
  if (answer.before) s += degrees_text(scene, answer.before->pair, "from_deg", *answer.from);
  if (answer.after) s += degrees_text(scene, answer.after->pair, "to_deg", *answer.to);
  return s + "}";
}

}  // namespace

std::string range_json(const Scene& scene, double from, const Range& answer, Touch touch) {
  std::string s = io::verdict_json(scene, to_string(answer.outcome)) + reason_text(answer.reason);
  s += ",\"range\":" + range_text(scene, answer) + ",\"around\":" + io::number_text(from);
  if (answer.before) s += ",\"before\":" + overlap_text(scene, *answer.before);
  if (answer.after) s += ",\"after\":" + overlap_text(scene, *answer.after);
  s += io::geometry_json(answer.geometry) + io::coverage_json(answer.coverage);
  return s + question_scope(scene, touch) + "}";
}

}  // namespace taut
