#include "import/import.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "geometry/part_validation.hpp"
#include "geometry/predicates.hpp"
#include "import/dxf_reader.hpp"
#include "import/kept_curves.hpp"
#include "import/nesting.hpp"
#include "import/svg_reader.hpp"
#include "io/number_text.hpp"
#include "io/outline_reader.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
#include "taut/grid.hpp"
#include "taut/io.hpp"
#include "taut/validate.hpp"

namespace taut::drawing {

namespace {

/// ".svg" of "a/b.SVG".
std::string ending_of(const std::string& file) {
  const std::size_t dot = file.rfind('.'), slash = file.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = file.substr(dot);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

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

Drawing read_map(std::string text, const std::string& file, const ImportSettings& settings, bool wkt) {
  Drawing drawing{file, wkt ? "WKT" : "GeoJSON", "the file's own", {}, {}, {}};
  const auto add = [&](const std::string& name, std::vector<Part> parts) {
    if (settings.scale != 1) scale_parts(parts, settings.scale);
    drawing.layers.push_back({name, {Sheet{"", Fill::even_odd, {}, false, std::move(parts)}}});
  };
  if (wkt) {
    add(stem_of(file), io::parse_wkt(text, file, {}));
    return drawing;
  }
  for (io::GeoFeature& feature : io::parse_geojson_features(std::move(text), file, {})) {
    for (const std::string& skipped : feature.skipped) {
      const std::size_t end = skipped.rfind(": ");
      drawing.skip(skipped.substr(0, end), "geometry", skipped.substr(end + 2));
    }
    if (!feature.parts.empty()) add(feature.name.empty() ? stem_of(file) : feature.name, std::move(feature.parts));
  }
  return drawing;
}

/// A robot's map: a body for each set of cells that hang together.
Drawing read_occupancy(const std::string& file, const ImportSettings& settings) {
  GridOptions options;
  options.unknown_occupied = !settings.unknown_free;
  const OccupancyGrid grid = read_grid(file, options);
  Drawing drawing{file,
                  "occupancy grid",
                  std::to_string(grid.width) + " x " + std::to_string(grid.height) + " cells of " +
                      io::number_text(grid.resolution),
                  {},
                  {},
                  {}};
  for (Body& body : grid_bodies(grid)) {
    if (settings.scale != 1) scale_parts(body.parts, settings.scale);
    drawing.layers.push_back({body.name, {Sheet{"", Fill::even_odd, {}, false, std::move(body.parts)}}});
  }
  return drawing;
}

/// Makes bodies of one file after the other.
class BodyMaker {
 public:
  BodyMaker(const ImportSettings& settings, Import& import) : settings_(settings), import_(import) {}

  void add(Drawing drawing) {
    file_ = {drawing.file,
             drawing.format,
             drawing.units,
             drawing.curves,
             {},
             std::move(drawing.skipped),
             0,
             std::move(drawing.chorded)};
    const CurveFinder finder(drawing.kept);
    finder_ = settings_.curves ? &finder : nullptr;
    const std::size_t before = import_.scene.bodies.size();
    for (Layer& layer : drawing.layers) add_layer(layer);
    if (import_.scene.bodies.size() == before) {
      std::string reasons;
      for (const Skipped& s : file_.skipped) {
        if (reasons.size() > 400) break;
        reasons += (reasons.empty() ? "; skipped: " : ", ") + s.what + " at " + s.place + " " + s.reason;
      }
      throw InputError(drawing.file, "nothing in the file encloses an area" + reasons,
                       "draw closed lines; ends that do not meet are joined with --join E");
    }
    file_.kept = finder.found();
    import_.files.push_back(std::move(file_));
  }

 private:
  struct Named {
    std::string name, place;
    Part part;
  };

  void add_layer(Layer& layer) {
    std::vector<Named> parts;
    for (Sheet& sheet : layer.sheets) add_sheet(sheet, parts);
    if (parts.empty()) return;
    for (const Named& named : parts) validate_part(named, layer.name);
    if (!settings_.split) {
      std::vector<Part> all;
      for (Named& named : parts) all.push_back(std::move(named.part));
      return add_body(layer.name, std::move(all));
    }
    for (Named& named : parts) add_body(named.name.empty() ? layer.name : named.name, {std::move(named.part)});
  }

  void add_sheet(Sheet& sheet, std::vector<Named>& parts) {
    for (Part& part : sheet.parts) parts.push_back({sheet.name, file_.file, std::move(part)});
    std::vector<Chain> rings = std::move(sheet.chains), open;
    require_range(rings);
    if (sheet.lines) rings = join_chains(std::move(rings), settings_.join_distance(), file_.joins, open);
    for (const Chain& chain : open) {
      skip(chain.place, "line", "is open: no other end is near enough to be joined to its own");
    }
    std::erase_if(rings, [&](Chain& ring) {
      if (tidy_ring(ring.points)) return false;
      skip(ring.place, "line", "encloses nothing");
      return true;
    });
    int idle = 0;
    for (NestedPart& nested : nest(rings, sheet.fill, idle))
      parts.push_back({sheet.name, nested.place, std::move(nested.part)});
    for (int i = 0; i < idle; ++i) skip(rings[0].place, "subpath", "has filled area on both of its sides");
  }

  /// What is computed from here on needs numbers that do not overflow.
  static void require_range(const std::vector<Chain>& chains) {
    for (const Chain& chain : chains) {
      for (const Point& p : chain.points) {
        if (std::fabs(p.x) < max_coordinate && std::fabs(p.y) < max_coordinate) continue;
        throw InputError(chain.place, "a coordinate is beyond 2^400", "choose another unit, or check the drawing");
      }
    }
  }

  void skip(const std::string& place, const std::string& what, const std::string& reason) {
    Drawing counted;
    counted.skipped = std::move(file_.skipped);
    counted.skip(place, what, reason);
    file_.skipped = std::move(counted.skipped);
  }

  void validate_part(const Named& named, const std::string& layer) const {
    const std::string name = named.place + (layer.empty() ? "" : ": " + io::excerpt(layer));
    validate_polygon(named.part.outline, name);
    for (std::size_t i = 0; i < named.part.holes.size(); ++i)
      validate_polygon(named.part.holes[i], name + ", hole " + std::to_string(i + 1));
    validate_holes(named.part, name);
  }

  void add_body(const std::string& wanted, std::vector<Part> parts) {
    Body body;
    body.name = unused_name(wanted);
    BodyReport report{body.name, file_.file, parts.size(), 0, 0};
    for (const Part& part : parts) {
      report.holes += part.holes.size();
      report.vertices += part.outline.size();
      for (const Polygon& hole : part.holes) report.vertices += hole.size();
    }
    take_curves(parts, body);
    if (!body.curves.empty()) return keep_body(std::move(body), std::move(report));
    if (parts.size() == 1 && parts[0].holes.empty())
      body.polygon = std::move(parts[0].outline);
    else
      body.parts = std::move(parts);
    keep_body(std::move(body), std::move(report));
  }

  void keep_body(Body body, BodyReport report) {
    import_.scene.bodies.push_back(std::move(body));
    import_.bodies.push_back(std::move(report));
  }

  /// The curves that the rings were made of, if there are any.
  void take_curves(const std::vector<Part>& parts, Body& body) const {
    if (!finder_) return;
    bool any = false;
    for (const Part& part : parts) {
      CurvedPart curved{finder_->outline(part.outline), {}};
      for (const Polygon& hole : part.holes) curved.holes.push_back(finder_->outline(hole));
      any = any || !polygons_of(curved);
      body.curves.push_back(std::move(curved));
    }
    if (!any) return body.curves.clear();
    // Throws where curves meet though their chords do not.
    flatten(body.curves, CurveSide::outer, 1e300, body.name);
  }

  /// Bodies are told apart by their names; a name has no line breaks in it.
  std::string unused_name(const std::string& wanted) {
    std::string base;
    for (const char c : wanted.empty() ? "body" : wanted)
      base += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
    std::string name = base;
    int& count = names_[base];
    while (!used_.insert(name).second) name = base + "-" + std::to_string(++count + 1);
    return name;
  }

  ImportSettings settings_;
  Import& import_;
  const CurveFinder* finder_ = nullptr;  ///< of the file that is read, where curves are kept
  FileReport file_;
  std::map<std::string, int> names_;
  std::set<std::string> used_;
};

}  // namespace

Drawing read_drawing(std::string text, const std::string& file, const ImportSettings& settings) {
  const std::string ending = ending_of(file);
  if (ending == ".svg") return read_svg(text, file, settings);
  if (ending == ".dxf") return read_dxf(text, file, settings);
  if (ending == ".wkt") return read_map(std::move(text), file, settings, true);
  if (ending == ".geojson" || ending == ".json") return read_map(std::move(text), file, settings, false);
  throw InputError(file, "the ending of the file's name is none of .svg, .dxf, .wkt, .geojson, .json and .yaml",
                   "give the file the ending of its format");
}

Import import_drawings(std::vector<Drawing> drawings, const ImportSettings& settings) {
  Import import;
  import.scene.start = 0;
  import.scene.end = 1;
  BodyMaker maker(settings, import);
  for (Drawing& drawing : drawings) maker.add(std::move(drawing));
  return import;
}

Import import_files(const std::vector<std::string>& files, const ImportSettings& settings) {
  std::vector<Drawing> drawings;
  for (const std::string& file : files) {
    const std::string ending = ending_of(file);
    drawings.push_back(ending == ".yaml" || ending == ".yml"
                           ? read_occupancy(file, settings)
                           : read_drawing(io::read_text_file(file, ReadLimits{}.max_bytes), file, settings));
  }
  return import_drawings(std::move(drawings), settings);
}

}  // namespace taut::drawing
