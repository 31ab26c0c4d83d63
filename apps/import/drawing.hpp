// What a drawing comes to before it is bodies: chains of straight lines, in layers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/outline.hpp"

namespace taut::drawing {

/// What becomes a body of a drawing's lines.
enum class Grouping {
  automatic,  ///< layers; but contours of one layer within material of another are its holes
  layer,      ///< layers, each by itself
  color,      ///< lines of one color, by themselves
  group,      ///< groups of SVG, and blocks of DXF where they are inserted, by themselves
  nesting     ///< each outermost outline with all that lies in it, whatever its layer
};

/// What becomes of lines that stay open although they seem meant to be closed.
enum class OpenRings { error, close, skip };

/// What becomes of closed contours around material, drawn as lines, that cross each other.
enum class Crossing {
  error,
  parts,    ///< they divide what they enclose
  unite,    ///< they are one part
  subtract  ///< those that have a part in a larger one are taken out of it, and no material
};

/// The heights between which the bodies of a layer lie.
struct LayerHeights {
  std::string name;
  Layers z;
};

/// How the user wants drawings read. Lengths are in units of the scene. Those that are not given follow from the
/// drawing's unit and size, see fineness_of().
struct ImportSettings {
  std::optional<double> tolerance;  ///< the most that a chord may be away from its curve
  std::optional<double> join;       ///< ends at most so far apart, or so far from a line, meet
  std::optional<double> repair;     ///< loops and crossings of a ring with itself up to this size are cut off
  double scale = 1;                 ///< all lengths are multiplied by this
  std::string unit = {};            ///< of drawings that state none, see unit_named(); empty if it is not known
  bool curves = false;  ///< curves stay curves where scenes have such: chords stand for them while lines are joined
  bool split = false;   ///< a body for each part
  Grouping by = Grouping::automatic;
  OpenRings open = OpenRings::error;
  Crossing crossing = Crossing::error;
  bool strict = false;                ///< what is not read is an error
  std::vector<std::string> layers;    ///< only these, if there are any
  std::vector<LayerHeights> heights;  ///< of some of them, in units of the scene: `scale` does not change them
  std::vector<std::string> merged;    ///< these layers are one
  bool merge_all = false;             ///< all layers are one
  std::optional<double> drills;       ///< of a board: those that are at least so wide are holes in it
  bool unknown_free = false;          ///< of a robot's map: cells that are neither free nor occupied are no obstacles
  std::size_t max_points = 20000000;  ///< of a whole file: a hostile one must not fill the memory
};

/// How many millimetres the unit has: mm, cm, m, um, in, ft, mil, pt or px; nothing for other words.
std::optional<double> unit_named(const std::string& name);

/// The lengths that decide what is the same, in units of the scene.
struct Fineness {
  double tolerance = 0.01, join = 0.02, repair = 0.1;
};

/// As the settings say; else 0.01, 0.02 and 0.1 mm for a drawing whose diagonal is 10 mm to 2 m, and in proportion to
/// the diagonal for smaller and larger ones. `millimetre` is how long one is in the scene; 1 if that is not known.
Fineness fineness_of(const ImportSettings& settings, double millimetre, double diagonal);

/// What is inside, where rings lie in each other: what an odd number of them goes around, what any goes around more
/// often one way than the other, and what just one goes around, counterclockwise.
enum class Fill { even_odd, nonzero, once };

/// Points joined by straight lines.
struct Chain {
  std::vector<Point> points;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
  std::string place;    ///< file and line
};

/// Chains that are filled together.
struct Sheet {
  std::string name;  ///< of the element, if it has one
  Fill fill = Fill::even_odd;
  std::vector<Chain> chains;
  bool lines = false;            ///< not filled: chains are joined where their ends meet
  std::vector<Part> parts = {};  ///< where the file says itself what is a hole
  bool alone = false;            ///< lines that are not put together with those of other sheets
  std::optional<Layers> z = {};  ///< the heights between which it lies: sheets with other ones are read apart
};

/// What becomes a body.
struct Layer {
  std::string name;
  std::vector<Sheet> sheets;
  std::vector<Chain> cutouts = {};  ///< closed, and taken out of what the sheets enclose, also across its boundary
};

/// A shape that was not read, although it may bound material, as texts and dimensions do not.
struct LostShape {
  std::string place;
  std::vector<Point> points;  ///< it lies in their box; if there are none, it may lie anywhere
  bool filling = false;       ///< it fills what its points go around: that is no hole
  bool hidden = false;        ///< an open line that is not to be seen: its points are its ends
};

/// What did not become part of a body, and why; the first one of its kind and layer.
struct Skipped {
  std::string place, what, reason;
  std::string layer = {}, handle = {};  ///< of DXF
  bool unread = false;  ///< it was to be seen in the drawing, and may have been meant as a part of a body
  int times = 1;
  std::vector<LostShape> shapes = {};  ///< of all of its kind and layer
  std::string remedy = {};             ///< of what changes shapes that are read: it is an error in any case
  std::string advice = {};             ///< how to have it read; empty for the usual
};

/// A curve that a scene can have, and the points that stand for it between its ends; at least one.
struct KeptCurve {
  std::vector<Point> inner;
  CurveSegment segment;
};

/// A shape of which it is not known where it lies.
inline Skipped lost(const std::string& place, const std::string& what, const std::string& reason,
                    const std::string& layer = "") {
  return {place, what, reason, layer, "", true, 1, {{place, {}}}};
}

/// A style that was not read: it may change any shape.
inline Skipped lost_style(const std::string& place, const std::string& what, const std::string& reason,
                          const std::string& remedy) {
  return {place, what, reason, "", "", true, 1, {{place, {}}}, remedy};
}

/// Curves that became chords.
struct CurveCounts {
  std::size_t segments = 0, chords = 0;
  double deviation = 0;  ///< of any curve from its chords, at most
};

/// Curves that scenes do not have, and which are chords though curves were to be kept; the first one of its kind and
/// layer.
struct Chorded {
  std::string place, what, layer;
  std::size_t entities = 0;
  CurveCounts counts = {};
};

struct Drawing {
  std::string file, format, units;
  std::vector<Layer> layers;
  std::vector<Skipped> skipped;
  CurveCounts curves;
  std::vector<std::string> notes = {};  ///< decisions that a person should know of
  std::string remedy = {};              ///< what to do if nothing in the file encloses an area; empty for the usual
  std::vector<KeptCurve> kept = {};
  std::vector<Chorded> chorded = {};
  std::vector<std::string> layer_names = {};  ///< that options may name; if empty, those of `layers`
  bool any_case = false;                      ///< are names the same in small letters and capitals?
  bool nests = true;                          ///< may lines of one layer be holes in what another one encloses?
  std::optional<double> unit = {};            ///< how many millimetres its unit has, if that is known
  double millimetre = 1;                      ///< how long one is in the scene, if that is known
  Fineness fineness = {};

  /// The layer of this name, which is made if there is none.
  Layer& layer(const std::string& name);
  void skip(Skipped more);
  void skip(const std::string& place, const std::string& what, const std::string& reason) {
    skip(Skipped{place, what, reason});
  }
  void count_chorded(const Chorded& more);
  /// What the file says of its unit, and how many millimetres it has; nothing if it says none.
  void state_unit(const std::string& text, std::optional<double> millimetres, const ImportSettings& settings);
  /// The diagonal of all that is drawn; 0 if that is nothing.
  double diagonal() const;
};

/// At this tolerance a drawing has about the size that it has, and no more is asked for.
constexpr double coarsest = 1e300;

/// What `read(tolerance)` makes of a file, with the fineness that fits it: where the settings give no tolerance, the
/// file is read twice, first coarsely for its size and unit.
template <class Read>
Drawing with_fineness(const ImportSettings& settings, const Read& read) {
  Fineness fineness = fineness_of(settings, 1, 0);
  if (!settings.tolerance || !settings.join || !settings.repair) {
    const Drawing coarse = read(settings.tolerance.value_or(coarsest));
    fineness = fineness_of(settings, coarse.millimetre, coarse.diagonal());
  }
  Drawing drawing = read(fineness.tolerance);
  drawing.fineness = fineness;
  return drawing;
}

}  // namespace taut::drawing
