// Drawings and maps as scenes: bodies that rest, to give motions to.
#pragma once

#include <string>
#include <vector>

#include "import/chains.hpp"
#include "import/drawing.hpp"
#include "taut/scene.hpp"

namespace taut::drawing {

/// What became of a file.
struct FileReport {
  std::string file, format, units;
  CurveCounts curves;
  JoinCounts joins;
  std::vector<Skipped> skipped;
  std::size_t kept = 0;               ///< segments of outlines that stayed curves
  std::vector<Chorded> chorded = {};  ///< curves that did not, though they were to
};

struct BodyReport {
  std::string name, file;
  std::size_t parts = 0, holes = 0, vertices = 0;
};

struct Import {
  Scene scene;  ///< over the time [0, 1]; every body is valid
  std::vector<FileReport> files;
  std::vector<BodyReport> bodies;
};

/// Reads SVG, DXF, WKT and GeoJSON files, and maps of map_server by their YAML files, told by their endings. Throws
/// InputError naming the file, the line and the remedy, also where nothing in a file encloses an area, and where a ring
/// meets itself or another ring of its part.
Import import_files(const std::vector<std::string>& files, const ImportSettings& settings);

/// The same of drawings that have been read.
Import import_drawings(std::vector<Drawing> drawings, const ImportSettings& settings);

/// The drawing in a text, by the ending of the name of its file.
Drawing read_drawing(std::string text, const std::string& file, const ImportSettings& settings);

/// For people: what was read, approximated, joined and skipped, in several lines.
std::string report_text(const Import& import, const ImportSettings& settings);
/// The same as a JSON object on one line.
std::string report_json(const Import& import, const ImportSettings& settings);

}  // namespace taut::drawing
