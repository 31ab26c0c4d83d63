// The distance of bodies over time, as JSON and as comma-separated values.
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

template <class Item, class Text>
std::string json_list(const std::vector<Item>& items, const Text& text) {
  std::string s = "[";
  for (const Item& item : items) s += (s.size() > 1 ? "," : "") + text(item);
  return s + "]";
}

std::string curve_json(const Scene& scene, const DistanceCurve& c) {
  std::string s = "{\"pair\":" + (c.pair ? io::pair_names_json(scene, *c.pair) : std::string("null"));
  s += ",\"largest\":{\"lo\":" + io::number_text(c.largest_lo) + ",\"hi\":" + io::number_text(c.largest_hi) +
       ",\"t\":" + io::number_text(c.largest_at) + ",\"settled\":" + (c.settled ? "true" : "false") + "}";
  s += ",\"instants\":" + json_list(c.instants, [](const DistanceAt& d) { return io::array_text({d.t, d.lo, d.hi}); });
  return s + ",\"stretches\":" +
         json_list(c.stretches,
                   [](const DistanceWithin& d) {
                     return io::array_text({d.from, d.to, d.lo, d.hi});
                   }) +
         "}";
}

/// Quoted where it has to be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string s = "\"";
  for (const char c : text) s += c == '"' ? std::string("\"\"") : std::string(1, c);
  return s + "\"";
}

}  // namespace

std::string profile_json(const Scene& scene, const DistanceProfile& answer) {
  std::string s = io::verdict_json(scene, to_string(answer.outcome));
  s += ",\"profile\":" + json_list(answer.curves, [&](const DistanceCurve& c) { return curve_json(scene, c); });
  if (!answer.reason.empty()) s += ",\"reason\":" + io::string_text(answer.reason);
  return s + io::geometry_json(answer.geometry) + io::coverage_json(answer.coverage) +
         ",\"scope\":{\"time\":" + io::array_text({scene.start, scene.end}) + "}}";
}

std::string profile_csv(const Scene& scene, const DistanceProfile& answer) {
  std::string s = "first,second,t,lo,hi,until_lo,until_hi\n";
  for (const DistanceCurve& c : answer.curves) {
    const auto name = [&](std::size_t i) {
      return c.pair ? csv_field(scene.bodies[static_cast<std::size_t>((*c.pair)[i])].name) : std::string();
    };
    const std::string pair = name(0) + "," + name(1) + ",";
    for (std::size_t k = 0; k < c.instants.size(); ++k) {
      const DistanceAt& d = c.instants[k];
      s += pair + io::number_text(d.t) + "," + io::number_text(d.lo) + "," + io::number_text(d.hi) + ",";
      if (k < c.stretches.size())
        s += io::number_text(c.stretches[k].lo) + "," + io::number_text(c.stretches[k].hi) + "\n";
      else
        s += ",\n";
    }
  }
  return s;
}

}  // namespace taut
