// Outlines kept in files of their own.
#pragma once

#include <string>

#include "taut/geometry.hpp"
#include "taut/io.hpp"

namespace taut::io {

/// As taut::read_wkt and taut::read_geojson, but from text; `name` stands for the file in messages.
Polygon parse_wkt(const std::string& text, const std::string& name, const ReadLimits& limits);
Polygon parse_geojson(std::string text, const std::string& name, const ReadLimits& limits);

/// Files repeat a ring's first vertex at its end; a Polygon does not.
void drop_repeated_last_vertex(Polygon& ring);

}  // namespace taut::io
