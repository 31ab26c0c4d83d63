// Reading scenes and outlines, writing scenes and pictures of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/envelope.hpp"
#include "taut/motions.hpp"
#include "taut/path.hpp"
#include "taut/scene.hpp"
#include "taut/simulation.hpp"

namespace taut {

/// Limits on what is read, so that hostile input fails early and clearly.
struct ReadLimits {
  std::size_t max_bytes = std::size_t{1} << 30;     ///< of one file
  std::size_t max_vertices = std::size_t{1} << 27;  ///< of one polygon
  std::size_t max_pieces = std::size_t{1} << 20;    ///< of one motion; also keyframes
  /// May the files that a scene names lie outside of the scene's folder (symbolic links followed)? If so, who writes
  /// the scene chooses what is read.
  bool allow_outside = false;
};

/// Reads a scene in the format taut-scene/1; outlines named by {"wkt": file} or {"geojson": file}, and keyframes named
/// by {"csv": file}, are found relative to the scene's folder, and must lie below it; errors about them do not quote
/// them. Only regular files are read. Throws InputError naming the file, line and column or JSON path, and the remedy.
/// The geometry itself (simple polygons, joints of motions, ...) is validated by check() and Simulation, or by
/// validate() in taut/validate.hpp.
Scene read_scene(const std::string& path, const ReadLimits& limits = {});
/// The same from text in memory; `name` stands for the file in messages, `folder` is where outlines are looked up.
Scene parse_scene(const std::string& text, const std::string& name = "scene", const std::string& folder = ".",
                  const ReadLimits& limits = {});
/// Reads a scene that has joints instead of a time, for envelope(): {"format":"taut-scene/1","joints":{"lift":[0,60]},
/// "bodies":[...]}, where a body's "motion" follows a joint. Otherwise as read_scene().
Linkage read_linkage(const std::string& path, const ReadLimits& limits = {});
/// The same from text in memory.
Linkage parse_linkage(const std::string& text, const std::string& name = "scene", const std::string& folder = ".",
                      const ReadLimits& limits = {});
/// Reads a scene that has joints, a start and a goal, for find_path(): as read_linkage() does, with "start": {"x": 1},
/// "goal": {"x": [8, 9]} or "outside", and "periodic": ["turn"]. read_linkage() passes over these three.
PathProblem read_path_problem(const std::string& path, const ReadLimits& limits = {});
/// The same from text in memory.
PathProblem parse_path_problem(const std::string& text, const std::string& name = "scene",
                               const std::string& folder = ".", const ReadLimits& limits = {});
/// One JSON object, the inverse of parse_scene: numbers are written so that they read back the same. Motions are
/// written as their pieces, whatever they were compiled from: a sweep is then a rotation like any other (Motion::sweep
/// is lost).
std::string write_scene(const Scene& scene);

/// Reads the polygons of a file with a WKT POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION of these, holes included
/// (repeated last vertices are dropped): at least one. Throws InputError naming the file, line and column, and the
/// remedy, also for geometries that are no polygons.
std::vector<Part> read_wkt_parts(const std::string& path, const ReadLimits& limits = {});
/// Reads the polygons of a GeoJSON Polygon, MultiPolygon or GeometryCollection, and of a Feature or a FeatureCollection
/// of these, holes included: at least one. Throws as read_wkt_parts() does.
std::vector<Part> read_geojson_parts(const std::string& path, const ReadLimits& limits = {});
/// The same from text in memory; `name` stands for the file in messages.
std::vector<Part> parse_wkt_parts(const std::string& text, const std::string& name = "outline",
                                  const ReadLimits& limits = {});
/// The same from text in memory.
std::vector<Part> parse_geojson_parts(const std::string& text, const std::string& name = "outline",
                                      const ReadLimits& limits = {});
/// The only outline of a file that read_wkt_parts() reads. Throws InputError if there are several polygons, or holes.
Polygon read_wkt(const std::string& path, const ReadLimits& limits = {});
/// The only outline of a file that read_geojson_parts() reads. Throws InputError if there are several, or holes.
Polygon read_geojson(const std::string& path, const ReadLimits& limits = {});
/// The same from text in memory; `name` stands for the file in messages.
Polygon parse_wkt(const std::string& text, const std::string& name = "outline", const ReadLimits& limits = {});
/// The same from text in memory.
Polygon parse_geojson(const std::string& text, const std::string& name = "outline", const ReadLimits& limits = {});
/// Reads keyframes for from_keyframes(): a header of the columns t, x, y, angle_deg in any order (those left out are 0,
/// t must be there), then a line of numbers for each keyframe, in order of time. Fields are separated by commas; spaces
/// around them and blank lines are skipped.
std::vector<Keyframe> read_keyframes_csv(const std::string& path, const ReadLimits& limits = {});

/// A line to draw over a picture.
struct DrawnPath {
  /// What the line is; it has a style of its own, and an entry in the legend.
  enum class Kind : std::uint8_t {
    geodesic_0,  ///< a geodesic of body 0, in its colour
    geodesic_1,  ///< of body 1
    separator,
    gone,   ///< what an event removes
    come,   ///< what an event adds
    guide,  ///< a construction line
  };
  std::vector<Point> points;  ///< world coordinates
  Kind kind = Kind::separator;
  bool closed = false;
  std::vector<Point> stars;  ///< points to mark by a star: where a geodesic is pinned, as in the paper
};

/// A word to write into a picture, centred at a point in world coordinates.
struct DrawnLabel {
  Point at;
  std::string text;
};

/// What a picture of a tiling shows, and how.
struct TilingDrawOptions {
  int width = 800;           ///< pixels
  bool faces = true;         ///< colour the faces by depth in the chain tree
  bool certificates = true;  ///< mark the active corners
  bool edges = true;         ///< draw the edges of the tiling
  bool legend = true;
  std::string title = {};             ///< instead of the bodies' names and the time
  std::vector<DrawnPath> paths = {};  ///< drawn over the tiling
  std::vector<DrawnLabel> labels = {};
  /// Show the box of these points instead of the whole scene, if there are any.
  std::vector<Point> window = {};
  /// Mark this contact, if given.
  const Contact* contact = nullptr;
};
/// The path of a pinned geodesic cycle, stars where it is pinned.
DrawnPath drawn_cycle(const Tiling& tiling, const GeodesicCycle& cycle);
/// An SVG picture of two bodies and their tiling, at its time.
std::string draw_svg(const Scene& scene, const Tiling& tiling, const TilingDrawOptions& options = {});

/// A distance to mark in a picture: two points in world coordinates, and the text next to them.
struct DrawnDistance {
  std::array<Point, 2> points{};
  std::string text;
};

/// Directions to mark where a body has most room: sectors of a circle.
struct DrawnRose {
  BodyId body = 0;
  /// Counterclockwise from the first angle to the second, in degrees; where they are one, a line.
  std::vector<std::array<double, 2>> arcs;
};

/// A region of the world, drawn below the bodies in the colour of one.
struct DrawnRegion {
  BodyId body = 0;
  std::vector<Part> parts;
};

/// What a picture of a scene shows, and how.
struct DrawOptions {
  int width = 800;  ///< pixels
  bool legend = true;
  std::string title = {};  ///< instead of the bodies' names, or their number, and the time
  /// Contacts to mark, the pair named.
  std::vector<Contact> contacts = {};
  /// Pairs of bodies that overlap, to mark.
  std::vector<std::array<BodyId, 2>> overlaps = {};
  std::vector<DrawnDistance> distances = {};
  std::vector<DrawnRose> roses = {};
  std::vector<DrawnRegion> regions = {};
  /// Tilings to draw, as tilings_of_near_pairs() gives them: of rings that are no farther from each other than the
  /// smaller one is large, and of rings in holes.
  std::vector<NearTiling> tilings = {};
};
/// The same options with the contacts and overlaps of an answer, those at the same time included.
DrawOptions marked(const Answer& answer, DrawOptions options = {});
/// An SVG picture of all bodies of a scene at time t, parents composed: each in a colour of its own and, where there is
/// room, with its number in the legend, which shows parents by indentation and lists the pairs that are ignored. The
/// scene must be valid, and t within its time.
std::string draw_svg(const Scene& scene, double t, const DrawOptions& options = {});

/// What animate_svg() shows, and how.
struct AnimateOptions {
  DrawOptions draw = {};    ///< contacts and overlaps are marked on the last frame
  double seconds = 6;       ///< that the motion takes
  double pause = 2;         ///< seconds on the last frame, before it begins anew
  int frames = 120;         ///< between which bodies move straight and turn evenly; at least 2
  std::string ending = {};  ///< shown with the last frame: how it ends, in words
  /// The tilings to draw at an instant; called once for each frame. Between frames their lines move with the bodies.
  /// None are drawn without it.
  std::function<std::vector<NearTiling>(double)> tilings = {};
  bool free = false;  ///< it was proved that nothing meets: the bar of time is green, and not grey
};
/// The same as a picture that moves, without script, from the scene's start to `end` at an even pace, then from the
/// beginning. Who prefers reduced motion sees the last frame.
std::string animate_svg(const Scene& scene, double end, const AnimateOptions& options = {});

/// Writes the whole text or nothing: to a temporary file next to `path`, then renamed. Throws InputError.
void write_file(const std::string& path, const std::string& text);

}  // namespace taut
