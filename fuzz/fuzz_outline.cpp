// Any bytes are an outline or an InputError, as WKT and as GeoJSON; what is read has as many vertices as it may.
#include "io/json_text.hpp"
#include "io/outline_reader.hpp"
#include "io/terminal_text.hpp"
#include "require.hpp"
#include "taut/error.hpp"

using namespace taut;

namespace {

constexpr std::size_t max_vertices = 64;

ReadLimits limits() {
  ReadLimits few;
  few.max_vertices = max_vertices;
  return few;
}

template <class Read>
void look(const Read& read) {
  try {
    const Polygon ring = read();
    // A ring of one more that does not close passes here, and is refused where polygons are validated.
    fuzz::require(ring.size() <= max_vertices + 1, "more vertices than the limit");
    std::string wkt = "POLYGON ((", json = R"({"type":"Polygon","coordinates":[[)";
    for (std::size_t i = 0; i < ring.size(); ++i) {
      wkt += (i ? "," : "") + io::number_text(ring[i].x) + " " + io::number_text(ring[i].y);
      json += (i ? "," : "") + io::point_text(ring[i]);
    }
    if (ring.size() < 2 || ring.front() == ring.back()) return;
    fuzz::require(io::parse_wkt(wkt + "))", "again", limits()) == ring, "the outline changes on its way through WKT");
    fuzz::require(io::parse_geojson(json + "]]}", "again", limits()) == ring, "the outline changes as GeoJSON");
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
