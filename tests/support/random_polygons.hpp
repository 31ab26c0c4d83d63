// Random pairs of disjoint simple polygons with integer coordinates, in the families that the paper's structure
// answers to: apart, intertwined, nested, in corridors, combs, spirals, stars, convex.
#pragma once

#include <cstdint>
#include <vector>

#include "support/rng.hpp"
#include "taut/geometry.hpp"

namespace taut::testing {

enum class Family : std::uint8_t {
  apart,        ///< ragged polygons side by side
  intertwined,  ///< two trees of triangles grown through each other
  nested,       ///< a small polygon with a large one grown around it
  corridor,     ///< a small polygon in a chamber at the end of a winding corridor
  combs,        ///< two combs, the teeth of one in or before the slots of the other
  spirals,      ///< a spiral bar in a spiral slot
  stars,        ///< two star-shaped polygons side by side
  convex,       ///< two convex polygons side by side
};

inline constexpr Family all_families[] = {Family::apart, Family::intertwined, Family::nested, Family::corridor,
                                          Family::combs, Family::spirals,     Family::stars,  Family::convex};

const char* to_string(Family family);

struct PolygonPair {
  Polygon p, q;  ///< both counterclockwise, simple, |coordinates| < 2^20
};

/// Two disjoint simple polygons; the same for the same state of `rng`. With `grid`, all vertices lie on a coarse grid:
/// collinear triples, parallel and axis-aligned edges abound, and the polygons may touch (never overlap).
PolygonPair random_pair(Rng& rng, Family family, bool grid = false);

/// (cos, sin) of an angle given in turns, computed by a Taylor series: the same bits on every platform.
Point unit_vector(double turns);

}  // namespace taut::testing
