// Files that a scene names: outlines and keyframes.
#pragma once

#include <string>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/io.hpp"

namespace taut::internal::io {

/// As taut::read_wkt_parts and taut::read_geojson_parts, but from text; `name` stands for the file in messages.
std::vector<Part> parse_wkt(std::string text, const std::string& name, const ReadLimits& limits);
std::vector<Part> parse_geojson(std::string text, const std::string& name, const ReadLimits& limits);

/// What a WKT file holds besides its polygons.
struct WktRest {
  struct Geometry {
    std::string place, type;
    bool area = false;  ///< does it enclose an area, with curves?
  };
  std::vector<Geometry> others;  ///< that are no polygons
  bool heights = false;          ///< do vertices have z or m?
};

/// As parse_wkt(), but what is no polygon is listed instead of refused.
std::vector<Part> parse_wkt_polygons(std::string text, const std::string& name, const ReadLimits& limits,
                                     WktRest& rest);

/// The outline of the only part. Throws InputError if there are more, or holes.
Polygon only_outline(std::vector<Part> parts, const std::string& name);

/// A feature of GeoJSON with the polygons in it, or a geometry that is in none.
struct GeoFeature {
  std::string name;  ///< its id, or the name in its properties; may be empty
  std::vector<Part> parts;
  struct Other {
    std::string place, reason;
    bool area = false;  ///< may it enclose an area?
  };
  std::vector<Other> skipped;  ///< what is no polygon
  bool heights = false;        ///< do vertices have z?
};

/// Every feature by itself. What is no polygon is listed instead of refused.
std::vector<GeoFeature> parse_geojson_features(std::string text, const std::string& name, const ReadLimits& limits);

/// Files repeat a ring's first vertex at its end, and some repeat others where they are; a Polygon does not.
void drop_repeated_vertices(Polygon& ring);

/// Adds a part, or, if its holes touch its outline or each other at points, the parts that it is cut into.
void add_parts(std::vector<Part>& parts, Part part);

// Files that a scene names: outlines and keyframes.

/// The path of a file that a scene names, relative to the scene's folder. Throws InputError if it lies outside of that
/// folder, symbolic links followed, unless that is allowed: who sends a scene does not choose what is read.
std::string named_file(const std::string& folder, const std::string& file, bool allow_outside);

}  // namespace taut::internal::io
