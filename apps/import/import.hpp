// Drawings and maps as scenes: bodies that rest, to give motions to.
#pragma once

#include <string>
#include <vector>

#include "import/drawing.hpp"
#include "taut/error.hpp"
#include "taut/scene.hpp"

namespace taut::drawing {

/// An end of a line that was moved to meet another line.
struct GapReport {
  std::string place, layer;
  Point from, to;
  double width = 0;
};

/// A line that encloses nothing and is no part of a body.
struct OpenReport {
  std::string place, layer;
  std::vector<Point> points;
  Point nearest_start, nearest_end;     ///< the nearest other free end
  double gap_start = -1, gap_end = -1;  ///< how far away that is; below 0 if the end meets a line, or there is none
};

/// A ring of open lines: closed by straight lines, or probably meant to be closed.
struct RingReport {
  std::string place, layer;
  std::vector<std::pair<Point, Point>> gaps;
  double gap_length = 0, line_length = 0;
};

/// A loop, a crossing or a spike that was cut off, or a sliver that was filled.
struct RepairReport {
  std::string what, place, layer;
  Point at;
  double size = 0;
};

/// A contour that crosses or touches itself, more widely than what is cut off.
struct CrossingReport {
  std::string place, layer;
  Point at;
};

/// What became of a file.
struct FileReport {
  std::string file, format, units;
  Fineness fineness;
  CurveCounts curves;
  std::vector<GapReport> gaps;
  std::vector<OpenReport> open;
  std::vector<RingReport> closed, suspicious;
  std::vector<RepairReport> repairs;
  std::vector<CrossingReport> crossings;
  std::size_t repeated = 0;        ///< segments that were drawn more than once
  std::vector<std::string> notes;  ///< decisions that a person should know of
  std::vector<Skipped> skipped;
  std::size_t kept = 0;          ///< segments of outlines that stayed curves
  std::vector<Chorded> chorded;  ///< curves that did not, though they were to
};

struct BodyReport {
  std::string name, file;
  std::size_t parts = 0, holes = 0, vertices = 0;
  double area = 0;        ///< of the union of the parts of each pair of heights; of the chords, where there are curves
  double overlap = 0;     ///< by which the areas of the parts exceed that
  Point low, high;        ///< the box around it
  std::vector<Layers> z;  ///< the heights between which its parts lie, each pair once; empty if nothing says them
};

struct Import {
  Scene scene;  ///< over the time [0, 1]; every body is valid
  std::vector<FileReport> files;
  std::vector<BodyReport> bodies;
  std::vector<InputError> faults;  ///< why the scene is not what was drawn, or may not be
};

/// Reads SVG, DXF, WKT and GeoJSON files, boards of KiCad, and maps of map_server by their YAML files, distinguished by
/// their endings. What is wrong with the drawings themselves is in `faults`: lines that were meant to be closed and are
/// not, nothing that encloses an area, layers that can be read in two ways, rings that meet each other. Throws
/// InputError naming the file, the line and the remedy where a file cannot be read.
Import examine_files(const std::vector<std::string>& files, const ImportSettings& settings);

/// The same of drawings that have been read.
Import examine_drawings(std::vector<Drawing> drawings, const ImportSettings& settings);

/// As examine_drawings(), but throws the first of the faults.
Import import_drawings(std::vector<Drawing> drawings, const ImportSettings& settings);

/// The drawing in a text, by the ending of the name of its file.
Drawing read_drawing(std::string text, const std::string& file, const ImportSettings& settings);

/// For people: what was read, approximated, joined and skipped, in several lines.
std::string report_text(const Import& import, const ImportSettings& settings);
/// The same as a JSON object on one line, with everything that report_text() abridges.
std::string report_json(const Import& import, const ImportSettings& settings);
/// A picture: bodies grey, what stays open red, gaps and repairs marked. Marks have ids: "open-F-K", "gap-F-K",
/// "repair-F-K" and "crossing-F-K" are number K in the report of file F.
std::string report_svg(const Import& import);

}  // namespace taut::drawing
