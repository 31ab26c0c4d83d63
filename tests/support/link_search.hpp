// Oracles for separators that share no code with the library: exhaustive search over a lattice, and a check of a curve
// in rational arithmetic.
#pragma once

#include "support/triangulation.hpp"
#include "taut/geometry.hpp"

namespace taut::testing {

/// The fewest edges of a separator whose vertices are points of a lattice: all points with integer coordinates up to
/// `extent` in magnitude, and rays in directions with entries up to 4. It may touch the polygons. Counterclockwise
/// simple polygons with few vertices, coordinates below `extent`, insides disjoint. 0 if there is none.
int fewest_lattice_links(const std::vector<IntPoint>& p, const std::vector<IntPoint>& q, int extent);

/// Is this curve (see MinimumLinkSeparator) one that avoids the insides of both polygons and keeps them apart? Exact.
bool is_separator(const std::vector<Point>& curve, bool closed, const Polygon& p, const Polygon& q);

}  // namespace taut::testing
