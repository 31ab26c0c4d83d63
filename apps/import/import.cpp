#include "import/import.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "import/bodies.hpp"
#include "import/dxf_reader.hpp"
#include "import/file_kinds.hpp"
#include "import/kicad_reader.hpp"
#include "import/png_image.hpp"
#include "import/svg_reader.hpp"
#include "import/text_encoding.hpp"
#include "io/outline_reader.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
#include "taut/grid.hpp"
#include "taut/io.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

std::string stem_of(const std::string& file) {
  const std::string name = file.substr(file.rfind('/') + 1);
  return name.substr(0, name.rfind('.'));
}

void scale_parts(std::vector<Part>& parts, double scale) {
  const auto scaled = [scale](Polygon& ring) {
    for (Point& p : ring) p = {p.x * scale, p.y * scale};
  };
  for (Part& part : parts) {
    scaled(part.outline);
    for (Polygon& hole : part.holes) scaled(hole);
  }
}

const char* const heights_left_out = "z and m of vertices are left out: the plane is seen from above";

/// `area`: it may enclose one.
void skip_geometry(Drawing& drawing, const std::string& place, const std::string& what, const std::string& reason,
                   bool area) {
  Skipped skipped{place, what, reason, "", "", true};
  if (area) {
    skipped.shapes = {{place, {}}};
    skipped.advice = "make polygons of its curves: ST_CurveToLine() in PostGIS, or ogr2ogr -nlt CONVERT_TO_LINEAR";
    drawing.remedy = skipped.advice;
  }
  drawing.skip(std::move(skipped));
}

Drawing read_map(std::string text, const std::string& file, const ImportSettings& settings, bool wkt) {
  Drawing drawing;
  drawing.file = file;
  drawing.format = wkt ? "WKT" : "GeoJSON";
  drawing.remedy = "only polygons are read: make them of lines that are closed, with ST_MakePolygon() in PostGIS, say";
  drawing.state_unit("the file's own", std::nullopt, settings);
  const auto add = [&](const std::string& name, std::vector<Part> parts) {
    if (settings.scale != 1) scale_parts(parts, settings.scale);
    drawing.layers.push_back({name, {Sheet{"", Fill::even_odd, {}, false, std::move(parts)}}});
  };
  if (wkt) {
    io::WktRest rest;
    std::vector<Part> parts = io::parse_wkt_polygons(std::move(text), file, {}, rest);
    for (const io::WktRest::Geometry& other : rest.others)
      skip_geometry(drawing, other.place, other.type, other.area ? "has curves, and is not read" : "is no polygon",
                    other.area);
    if (rest.heights) drawing.notes.push_back(heights_left_out);
    if (!parts.empty()) add(stem_of(file), std::move(parts));
    drawing.fineness = fineness_of(settings, drawing.millimetre, drawing.diagonal());
    return drawing;
  }
  bool heights = false;
  for (io::GeoFeature& feature : io::parse_geojson_features(std::move(text), file, {})) {
    for (const io::GeoFeature::Other& other : feature.skipped)
      skip_geometry(drawing, other.place, "geometry", other.reason, other.area);
    heights = heights || feature.heights;
    if (!feature.parts.empty()) add(feature.name.empty() ? stem_of(file) : feature.name, std::move(feature.parts));
  }
  if (heights) drawing.notes.push_back(heights_left_out);
  drawing.fineness = fineness_of(settings, drawing.millimetre, drawing.diagonal());
  return drawing;
}

/// A robot's map: a body for each set of cells that hang together.
Drawing read_occupancy(const std::string& file, const ImportSettings& settings) {
  GridOptions options;
  options.unknown_occupied = !settings.unknown_free;
  options.read_image = read_png;
  const OccupancyGrid grid = read_grid(file, options);
  Drawing drawing;
  drawing.file = file;
  drawing.format = "occupancy grid";
  // Maps of ROS are in metres.
  drawing.state_unit("", 1000, settings);
  drawing.units = std::to_string(grid.width) + " x " + std::to_string(grid.height) + " cells of " +
                  io::number_text(grid.resolution);
  for (Body& body : grid_bodies(grid)) {
    if (settings.scale != 1) scale_parts(body.parts, settings.scale);
    drawing.layers.push_back({body.name, {Sheet{"", Fill::even_odd, {}, false, std::move(body.parts)}}});
  }
  return drawing;
}

Drawing read_file(const std::string& file, const ImportSettings& settings) {
  const std::string ending = ending_of(file);
  return ending == ".yaml" || ending == ".yml"
             ? read_occupancy(file, settings)
             : read_drawing(io::read_text_file(file, ReadLimits{}.max_bytes), file, settings);
}

[[noreturn]] void fail_unknown_unit(const Drawing& a, const Drawing& b) {
  const Drawing &known = a.unit ? a : b, &other = a.unit ? b : a;
  throw InputError(other.file,
                   "the file states no unit of length, but " + known.file + " does: how long is the one in the other?",
                   "say what it is drawn in, as --unit mm, or import the files by themselves");
}

}  // namespace

Drawing read_drawing(std::string text, const std::string& file, const ImportSettings& settings) {
  const std::string ending = ending_of(file);
  if (is_gzip(text)) text = unzipped(text, file);
  to_plain_utf8(text);
  if (ending == ".svg" || ending == ".svgz") return read_svg(text, file, settings);
  if (ending == ".dxf") return read_dxf(text, file, settings);
  if (ending == ".kicad_pcb") return read_kicad(text, file, settings);
  if (ending == ".wkt") return read_map(std::move(text), file, settings, true);
  static const std::set<std::string> json{".geojson", ".json", ".geojsonl", ".geojsons", ".ndjson"};
  if (json.count(ending)) return read_map(std::move(text), file, settings, false);
  refuse_kind(file);
}

Import examine_drawings(std::vector<Drawing> drawings, const ImportSettings& settings) {
  Import import;
  import.scene.start = 0;
  import.scene.end = 1;
  BodyMaker maker(settings, import);
  for (Drawing& drawing : drawings) maker.add(std::move(drawing));
  if (settings.strict) {
    for (const FileReport& file : import.files) {
      for (const Skipped& skipped : file.skipped) {
        if (skipped.unread)
          import.faults.emplace_back(skipped.place, skipped.what + " " + skipped.reason,
                                     "change the drawing, or leave out --strict to have it skipped");
      }
    }
  }
  return import;
}

Import import_drawings(std::vector<Drawing> drawings, const ImportSettings& settings) {
  Import import = examine_drawings(std::move(drawings), settings);
  if (!import.faults.empty()) throw import.faults.front();
  return import;
}

Import examine_files(const std::vector<std::string>& files, const ImportSettings& settings) {
  std::vector<Drawing> drawings;
  for (const std::string& file : files) {
    drawings.push_back(read_file(file, settings));
    const Drawing &first = drawings.front(), &last = drawings.back();
    if (first.unit == last.unit) continue;
    if (!first.unit || !last.unit) fail_unknown_unit(first, last);
    ImportSettings converted = settings;
    const double factor = *last.unit / *first.unit;
    converted.scale *= factor;
    drawings.back() = read_file(file, converted);
    drawings.back().notes.push_back("lengths are converted to the unit of " + first.file + ": times " +
                                    io::number_text(factor));
  }
  return examine_drawings(std::move(drawings), settings);
}

}  // namespace taut::drawing
