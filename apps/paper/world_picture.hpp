// A world with edges between and within its bodies.
#pragma once

#include <string>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::paper {

/// A straight edge of a tiling.
struct DrawnEdge {
  Point from, to;
  bool mixed = false;  ///< between two bodies that move relative to each other
};

/// The bodies grey, edges between them red, edges within them thin.
std::string draw_world(const std::vector<Polygon>& bodies, const std::vector<DrawnEdge>& edges);

}  // namespace taut::paper
