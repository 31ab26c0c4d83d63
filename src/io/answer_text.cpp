// Answers as tables and outlines: CSV, SVG paths, WKT, GeoJSON.
#include <algorithm>
#include <functional>

#include "io/answer_writer.hpp"
#include "io/json_writer.hpp"
#include "io/text.hpp"
#include "taut/cells.hpp"
#include "taut/clearance.hpp"
#include "taut/scene.hpp"
#include "taut/swept.hpp"

namespace taut {

// Cells that a body touches: as JSON, and as a map for map_server.

using namespace internal;
namespace {

struct CellRange {
  int i0 = 0, j0 = 0, i1 = -1, j1 = -1;
};

CellRange range_of_cells(const CoveredCells& covered) {
  if (covered.cells.empty()) return {};
  CellRange r{covered.cells[0][0], covered.cells[0][1], covered.cells[0][0], covered.cells[0][1]};
  for (const auto& [i, j] : covered.cells) {
    r.i0 = std::min(r.i0, i);
    r.i1 = std::max(r.i1, i);
    r.j0 = std::min(r.j0, j);
    r.j1 = std::max(r.j1, j);
  }
  return r;
}

}  // namespace

std::string cells_json(const Scene& scene, BodyId body, const CoveredCells& covered) {
  io::AnswerWriter json(scene);
  json.object([&] {
    json.key("body");
    json.name(body);
    json.member("resolution", covered.resolution);
    json.member("origin", covered.origin);
    if (scene.lock) json.lock(*scene.lock);
    json.key("cells").array(covered.cells, [&](const std::array<int, 2>& cell) {
      json.array([&] {
        json.integer(cell[0]);
        json.integer(cell[1]);
      });
    });
  });
  return json.text();
}

std::string cells_pgm(const CoveredCells& covered) {
  const CellRange r = range_of_cells(covered);
  if (covered.cells.empty()) return {};
  const auto width = static_cast<std::size_t>(r.i1 - r.i0 + 1), height = static_cast<std::size_t>(r.j1 - r.j0 + 1);
  std::string pixels(width * height, '\xfe');
  for (const auto& [i, j] : covered.cells)
    pixels[static_cast<std::size_t>(r.j1 - j) * width + static_cast<std::size_t>(i - r.i0)] = '\0';
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + pixels;
}

std::string cells_yaml(const CoveredCells& covered, const std::string& image_file) {
  const CellRange r = range_of_cells(covered);
  const double x = covered.origin.x + covered.resolution * r.i0, y = covered.origin.y + covered.resolution * r.j0;
  return "image: " + image_file + "\nresolution: " + io::number_text(covered.resolution) + "\norigin: [" +
         io::number_text(x) + ", " + io::number_text(y) + ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";
}

// The region that a body passes over: as JSON, WKT, GeoJSON and DXF.

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

// The distance of bodies over time, as comma-separated values.

using namespace internal;
std::string profile_csv(const Scene& scene, const DistanceProfile& answer) {
  std::string s = "first,second,t,lo,hi,until_lo,until_hi\n";
  for (const DistanceCurve& c : answer.curves) {
    const auto name = [&](std::size_t i) {
      return c.pair ? io::csv_field(scene.bodies[static_cast<std::size_t>((*c.pair)[i])].name) : std::string();
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
