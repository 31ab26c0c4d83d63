// Outlines with curves, as a user writes them: the segments of an SVG path.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "taut/geometry.hpp"

namespace taut {

struct Scene;

/// A straight line to a point.
struct LineTo {
  Point to;
};

/// An arc of an ellipse to a point, as in SVG: half-axes rx and ry > 0, the first turned by `rotation_deg` against the
/// x axis. Of the up to four arcs that there are, `large` takes those of more than half a turn, and `sweep` those that
/// run counterclockwise (where y points up). Radii that do not reach are enlarged until they do, all exactly.
struct ArcTo {
  double rx = 0, ry = 0, rotation_deg = 0;
  bool large = false, sweep = false;
  Point to;
};

/// A quadratic Bezier curve.
struct QuadraticTo {
  Point control, to;
};

/// A cubic Bezier curve.
struct CubicTo {
  Point first, second, to;
};

/// One segment of an outline, from where the one before ends.
using CurveSegment = std::variant<LineTo, ArcTo, QuadraticTo, CubicTo>;

/// Where a segment ends.
inline Point end_of(const CurveSegment& segment) {
  return std::visit([](const auto& s) { return s.to; }, segment);
}

/// A closed curve, in either orientation. It must not meet itself, also not at a tangency. Where the last segment does
/// not end at the start, a line does; it counts as one more segment. All numbers mean exactly what they say.
struct Outline {
  Point start;
  std::vector<CurveSegment> segments;
};

/// A connected piece of material bounded by curves: an outline minus holes, as taut::Part.
struct CurvedPart {
  Outline outline;
  std::vector<Outline> holes;
  std::optional<Layers> z = {};  ///< its own layers, in place of those of its body
};

/// What is inside, of a path with several subpaths: as in SVG.
enum class FillRule { nonzero, evenodd };

/// The outline of a polygon.
Outline outline_of(const Polygon& polygon);

/// The same part as polygons, if it is bounded by lines only; else nothing. Lines of no length are left out.
std::optional<Part> polygons_of(const CurvedPart& part);

/// The parts that an SVG path encloses: M L H V C S Q T A Z, either case; every subpath is closed. Where a subpath lies
/// in others, the rule says what is inside; subpaths must not meet each other or themselves. Throws InputError with the
/// character at fault, `name` as its place.
std::vector<CurvedPart> parse_path(std::string_view path, FillRule rule = FillRule::nonzero,
                                   const std::string& name = "path");

/// An SVG path that parse_path() reads as the same parts by the rule evenodd. Numbers are exact.
std::string write_path(const std::vector<CurvedPart>& parts);

/// Which side of a curve polygons are on.
enum class CurveSide {
  inner,  ///< within the shape
  outer,  ///< around the shape
};

/// A polygon for each ring of the parts, all of them within the shapes, or around them, and nowhere farther from the
/// curves than `tolerance`: both proved. For a smaller tolerance they lie between. Throws InputError where the curves
/// are not valid, or `tolerance` is less than 2^-40 of the largest coordinate.
std::vector<Part> flatten(const std::vector<CurvedPart>& parts, CurveSide side, double tolerance,
                          const std::string& name = "outline");

/// The scene with such polygons in place of the curves of its bodies; bodies without curves stay as they are. Throws
/// InputError as flatten() of parts does, for a body by its name.
Scene flatten(const Scene& scene, CurveSide side, double tolerance);

}  // namespace taut
