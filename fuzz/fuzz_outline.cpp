// Any bytes are an outline or an InputError, as WKT and as GeoJSON; what is read has as many vertices as it may.
#include "io/json_writer.hpp"
#include "io/outline_reader.hpp"
#include "io/text.hpp"
#include "require.hpp"
#include "taut/error.hpp"

using namespace taut;
using namespace taut::internal;

namespace {

constexpr std::size_t max_vertices = 64;

ReadLimits limits() {
  ReadLimits few;
  few.max_vertices = max_vertices;
  return few;
}

std::string wkt_ring(const Polygon& ring) {
  std::string s;
  for (const Point& p : ring) s += (s.empty() ? "" : ",") + io::number_text(p.x) + " " + io::number_text(p.y);
  return "(" + s + ")";
}

std::string json_ring(const Polygon& ring) {
  std::string s;
  for (const Point& p : ring) s += (s.empty() ? "" : ",") + io::point_text(p);
  return "[" + s + "]";
}

bool same(const std::vector<Part>& a, const std::vector<Part>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].outline != b[i].outline || a[i].holes != b[i].holes) return false;
  return true;
}

/// One that does not change where it is closed and opened again.
bool reads_back(const Polygon& ring) { return ring.size() >= 2 && ring.front() != ring.back(); }

template <class Read>
void look(const Read& read) {
  try {
    const std::vector<Part> parts = read();
    std::string wkt, json;
    for (const Part& part : parts) {
      std::vector<Polygon> rings = part.holes;
      rings.insert(rings.begin(), part.outline);
      std::string wkt_part, json_part;
      for (const Polygon& ring : rings) {
        fuzz::require(ring.size() <= max_vertices, "more vertices than the limit");
        if (!reads_back(ring)) return;
        wkt_part += (wkt_part.empty() ? "" : ",") + wkt_ring(ring);
        json_part += (json_part.empty() ? "" : ",") + json_ring(ring);
      }
      wkt += (wkt.empty() ? "(" : ",(") + wkt_part + ")";
      json += (json.empty() ? "[" : ",[") + json_part + "]";
    }
    fuzz::require(!parts.empty(), "a file without polygons");
    fuzz::require(same(io::parse_wkt("MULTIPOLYGON (" + wkt + ")", "again", limits()), parts),
                  "the polygons change on their way through WKT");
    fuzz::require(
        same(io::parse_geojson(R"({"type":"MultiPolygon","coordinates":[)" + json + "]}", "again", limits()), parts),
        "the polygons change as GeoJSON");
  } catch (const InputError& error) {
    fuzz::require(!error.problem().empty(), "an error that says nothing");
    // Nothing of the file is quoted, and so nothing that a terminal would obey.
    fuzz::require(io::for_terminal(error.problem()) == error.problem(), "an error with a control character");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  look([&] { return io::parse_wkt(text, "outline", limits()); });
  look([&] { return io::parse_geojson(text, "outline", limits()); });
  return 0;
}
