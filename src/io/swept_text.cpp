// The region that a body passes over: as JSON, WKT, GeoJSON and DXF.
#include <functional>

#include "io/answer_writer.hpp"
#include "io/json_writer.hpp"
#include "io/number_text.hpp"
#include "taut/scene.hpp"
#include "taut/swept.hpp"

namespace taut {
using namespace internal;
namespace {

/// Each ring of the region, the outline of a part before its holes.
void for_each_ring(const SweptRegion& region, const std::function<void(const Polygon&)>& visit) {
  for (const Part& part : region.parts) {
    visit(part.outline);
    for (const Polygon& hole : part.holes) visit(hole);
  }
}

template <class Items, class Write>
std::string in_brackets(const char* open, const Items& items, const char* close, const Write& write) {
  std::string text = open;
  for (std::size_t k = 0; k < items.size(); ++k) text += (k > 0 ? ", " : "") + write(items[k]);
  return text + close;
}

std::vector<Polygon> rings_of(const Part& part) {
  std::vector<Polygon> rings{part.outline};
  rings.insert(rings.end(), part.holes.begin(), part.holes.end());
  return rings;
}

Polygon closed(Polygon ring) {
  ring.push_back(ring.front());
  return ring;
}

void write_ring(io::JsonWriter& json, const Polygon& ring) {
  json.array(ring, [&](const Point& p) { json.numbers({p.x, p.y}); });
}

}  // namespace

std::string swept_json(const Scene& scene, BodyId body, const SweptRegion& region) {
  io::AnswerWriter json(scene);
  json.object([&] {
    json.key("body");
    json.name(body);
    json.member("tolerance", region.tolerance);
    json.member("area", region.area);
    if (scene.lock) json.lock(*scene.lock);
    json.key("parts").array(region.parts, [&](const Part& part) {
      json.object([&] {
        json.key("outline");
        write_ring(json, part.outline);
        if (part.holes.empty()) return;
        json.key("holes").array(part.holes, [&](const Polygon& hole) { write_ring(json, hole); });
      });
    });
  });
  return json.text();
}

std::string swept_wkt(const SweptRegion& region) {
  if (region.parts.empty()) return "MULTIPOLYGON EMPTY";
  const auto vertex = [](const Point& p) { return io::number_text(p.x) + " " + io::number_text(p.y); };
  const auto ring_text = [&](const Polygon& ring) { return in_brackets("(", closed(ring), ")", vertex); };
  const auto part_text = [&](const Part& part) { return in_brackets("(", rings_of(part), ")", ring_text); };
  return in_brackets("MULTIPOLYGON (", region.parts, ")", part_text);
}

std::string swept_geojson(const Scene& scene, BodyId body, const SweptRegion& region) {
  io::JsonWriter json;
  json.object([&] {
    json.member("type", "Feature");
    json.key("properties").object([&] {
      json.member("name", scene.bodies[static_cast<std::size_t>(body)].name);
      json.member("area", region.area);
      json.member("tolerance", region.tolerance);
    });
    json.key("geometry").object([&] {
      json.member("type", "MultiPolygon");
      json.key("coordinates").array(region.parts, [&](const Part& part) {
        json.array(rings_of(part), [&](const Polygon& ring) { write_ring(json, closed(ring)); });
      });
    });
  });
  return json.text();
}

std::string swept_dxf(const SweptRegion& region) {
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for_each_ring(region, [&](const Polygon& ring) {
    text += "0\nPOLYLINE\n8\nSWEPT\n66\n1\n10\n0\n20\n0\n30\n0\n70\n1\n";
    for (const Point& p : ring)
      text += "0\nVERTEX\n8\nSWEPT\n10\n" + io::number_text(p.x) + "\n20\n" + io::number_text(p.y) + "\n30\n0\n";
    text += "0\nSEQEND\n8\nSWEPT\n";
  });
  return text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace taut
