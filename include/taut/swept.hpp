// Which region does a moving body pass over? Keep-out zones, swept areas of vehicles, cut-outs for moving parts.
#pragma once

#include <string>
#include <vector>

#include "taut/feature.hpp"
#include "taut/limits.hpp"
#include "taut/scene.hpp"

namespace taut {

/// Of swept().
struct SweptOptions {
  /// How far the region may reach beyond what the body passes over, in units of the scene; 0: a thousandth of the
  /// diagonal of the body's box.
  double tolerance = 0;
  Limits limits = {};
};

/// What swept() found.
struct SweptRegion {
  double tolerance = 0;  ///< that was asked for
  /// The region, in world coordinates. Rings do not meet; outlines run counterclockwise, holes clockwise.
  std::vector<Part> parts;
  double area = 0;  ///< of the region, rounded
};

/// The region that a body passes over in the scene's time, wherever its motion and its parents' motions put it. It
/// certainly contains every point that the body, its boundary included, covers at any instant, whatever happens between
/// poses; and every point of it is within the tolerance of a point that the body covers at some instant. Other bodies
/// do not matter. A body with curves is taken as polygons around it, which are at most an eighth of the tolerance away.
///
/// Unions are made by Boost.Polygon on a grid of at most 1/512 of the tolerance, with room for what it rounds. The time
/// grows with the number of poses, about the way of the body over the square root of the tolerance times the size.
///
/// Throws InputError if the scene is not valid, if there is no such body, or if the tolerance is not positive or less
/// than 2^-17 of the extent of the region, or than 2^-39 of its largest coordinate; UndecidedError if it is stopped.
SweptRegion swept(const Scene& scene, BodyId body, const SweptOptions& options = {});

/// {"body": name, "tolerance": x, "area": a, "parts": [{"outline": [[x, y], ...], "holes": [...]}, ...]} on one line,
/// and after the area the "lock" of a mechanism, until which it is.
std::string swept_json(const Scene& scene, BodyId body, const SweptRegion& region);
/// A MULTIPOLYGON as WKT.
std::string swept_wkt(const SweptRegion& region);
/// A Feature of GeoJSON, with the body's name and the area as properties; coordinates are those of the scene.
std::string swept_geojson(const Scene& scene, BodyId body, const SweptRegion& region);
/// A drawing as DXF (R12): each ring a closed POLYLINE on the layer SWEPT.
std::string swept_dxf(const SweptRegion& region);
/// A picture of the region below all bodies at the start; `width` in pixels.
std::string swept_svg(const Scene& scene, BodyId body, const SweptRegion& region, int width = 800);

}  // namespace taut
