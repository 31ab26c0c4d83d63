// A convex polygon, and coarser ones around it: each has about half the sides of the next, drawn out until they meet.
#pragma once

#include <vector>

#include "taut/geometry.hpp"

namespace taut::paper {

/// One polygon of a hierarchy, counterclockwise.
struct HierarchyLevel {
  Polygon ring;
  /// Side k, from vertex k to the next one, is in the line of this side of the innermost polygon.
  std::vector<int> side;
  /// How far vertices are beyond sides that were left out, at most.
  double excess = 0;
};

/// The coarsest first; the last one is the polygon itself, which must be convex and counterclockwise, without three
/// vertices in line. Sides are left out, every other one, where the turn from the side before to the one after is at
/// most 120 degrees (Dobkin and Kirkpatrick's hierarchy, from outside).
std::vector<HierarchyLevel> outer_hierarchy(const Polygon& ring);

}  // namespace taut::paper
