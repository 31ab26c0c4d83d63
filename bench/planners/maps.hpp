// Maps for planners: what taut takes, and the same in convex pieces for others.
#pragma once

#include <string>
#include <vector>

#include "taut/map_query.hpp"
#include "taut/scene.hpp"

namespace taut::bench {

/// Counterclockwise convex polygons of at most 8 vertices.
using ConvexPieces = std::vector<Polygon>;

struct PlanMap {
  std::string name;
  std::vector<Body> bodies;
  ConvexPieces pieces;  ///< cover the same
  Body robot;
  ConvexPieces robot_pieces;
  Point lo, hi;  ///< bounds of x and y
  PoseSE2 start, goal;
};

/// Thin walls with gaps, random polygons, an office, a maze, and the harbour, whose outline is read from `folder`.
std::vector<PlanMap> plan_maps(const std::string& folder);

}  // namespace taut::bench
