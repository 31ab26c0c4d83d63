// Shorelines at full resolution, from the Debian package gmt-gshhg-full (GSHHG, Wessel and Smith 1996; LGPL), if that
// is installed. Nothing of the data is part of taut.
#pragma once

#include <string>

#include "taut/geometry.hpp"

namespace taut::bench {

/// Where the package puts the shorelines.
inline constexpr const char* gshhg_file = "/usr/share/gmt-gshhg/binned_GSHHS_f.nc";

/// Numbers of polygons in the file.
inline constexpr int gshhg_africa = 1, gshhg_south_america = 3;
/// How many vertices South America has; Africa has 257,835.
inline constexpr int gshhg_vertices = 338780;

/// Why shorelines cannot be read here; empty if they can.
std::string gshhg_obstacle();

/// One polygon of the file in the plane of longitude (x) and latitude (y): the plate carrée projection. The unit is
/// 65536/65535 of a degree, in which the file's integers are binary fractions, so that nothing is rounded. Longitudes
/// are between -180 and 180 degrees. Throws std::runtime_error.
Polygon read_gshhg(int polygon);

}  // namespace taut::bench
