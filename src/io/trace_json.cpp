#include "io/trace_json.hpp"

#include "io/json_text.hpp"

namespace taut::internal::io {

namespace {

std::string flags_text(const TraceEvent& e) {
  std::string s;
  const auto flag = [&s](bool set, const char* name) {
    if (set) s += (s.empty() ? "\"" : ",\"") + std::string(name) + "\"";
  };
  flag(e.bridging, "bridging");
  flag(e.pinch_rule, "pinch_rule");
  flag(e.three_corners, "three_corners");
  return "[" + s + "]";
}

}  // namespace

TraceWriter::TraceWriter(const Scene& scene) {
  for (const Body& body : scene.bodies) names_.push_back(string_text(body.name));
}

std::string TraceWriter::line(const TraceEvent& e) const {
  return "{\"event\":" + std::to_string(e.number) + ",\"t\":" + array_text({e.lo, e.hi}) + ",\"repair\":\"" +
         to_string(e.repair) + "\",\"corner\":[" + vertex_text(e.u) + "," + vertex_text(e.v) + "," + vertex_text(e.w) +
         "],\"flags\":" + flags_text(e) + ",\"certificates\":" + std::to_string(e.certificates) + "}";
}

std::string TraceWriter::vertex_text(const VertexRef& v) const {
  return "{\"body\":" + names_[static_cast<std::size_t>(v.body)] + ",\"index\":" + std::to_string(v.index) + "}";
}

}  // namespace taut::internal::io
