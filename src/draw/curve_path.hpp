// Curves in pictures, as curves.
#pragma once

#include <functional>
#include <string>

#include "taut/outline.hpp"

namespace taut::internal::io {

/// Takes a point of a body to where it is drawn: turned, moved, enlarged and mirrored, but never sheared.
using PlaceOnPage = std::function<Point(const Point&)>;

/// The rings of a part as the data of one SVG path, for the rule evenodd: arcs stay arcs, and Bezier curves what they
/// are.
std::string curve_path(const CurvedPart& part, const PlaceOnPage& place);

/// The rings as polygons for measuring, each near enough to its curve for a picture.
std::vector<Polygon> sketched(const CurvedPart& part);

}  // namespace taut::internal::io
