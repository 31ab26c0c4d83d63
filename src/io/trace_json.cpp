#include "io/trace_json.hpp"

#include "io/json_writer.hpp"

namespace taut::internal::io {

TraceWriter::TraceWriter(const Scene& scene) {
  for (const Body& body : scene.bodies) names_.push_back(string_text(body.name));
}

std::string TraceWriter::line(const TraceEvent& e) const {
  JsonWriter json;
  const auto vertex = [&](const VertexRef& v) {
    json.object([&] {
      json.key("body").raw(names_[static_cast<std::size_t>(v.body)]);
      json.member("index", v.index);
    });
  };
  const auto flag = [&](bool set, const char* name) {
    if (set) json.string(name);
  };
  json.object([&] {
    json.member("event", e.number);
    json.member("t", {e.lo, e.hi});
    json.member("repair", to_string(e.repair));
    json.key("corner").array(std::array{e.u, e.v, e.w}, vertex);
    json.key("flags").array([&] {
      flag(e.bridging, "bridging");
      flag(e.pinch_rule, "pinch_rule");
      flag(e.three_corners, "three_corners");
    });
    json.member("certificates", e.certificates);
  });
  return json.text();
}

}  // namespace taut::internal::io
