// A scene in the terms of the engines: which body is P, scaled coordinates, vertices in order.
#pragma once

#include <array>
#include <vector>

#include "motion/leg.hpp"
#include "motion/pair_geometry.hpp"
#include "taut/scene.hpp"

namespace taut {

/// Which body plays P or Q, and how its internal vertices are numbered in the input.
struct BodyMap {
  int body = 0;             ///< position in Scene::bodies
  std::uint32_t size = 0;   ///< number of vertices
  std::uint32_t first = 0;  ///< index of the input that became vertex 0
  bool reversed = false;    ///< the input runs clockwise

  int vertex(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + size - k) % size : (first + k) % size);
  }
  int edge(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + 2 * size - k - 1) % size : (first + k) % size);
  }
};

/// Everything about a scene that does not depend on the touch mode.
struct PairPlan {
  std::array<BodyMap, 2> maps;                     ///< of P and of Q
  std::array<std::vector<Point>, 2> polygons;      ///< scaled, counterclockwise, first vertex on the hull
  std::array<std::vector<MotionPiece>, 2> pieces;  ///< scaled
  int exponent = 0;                                ///< internal coordinates are the input's times 2^exponent
  double extent = 0;                               ///< of the scene, in the input's units
};

/// The scene must be valid (see validate()).
PairPlan plan_pair(const Scene& scene);

/// The two polygons, displaced inwards or outwards.
PairGeometry displaced_pair(const PairPlan& plan, bool inwards);

}  // namespace taut
