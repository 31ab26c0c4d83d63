// A gas of polygons in a box: how many there are, and how they begin.
#pragma once

#include <vector>

#include "elastic.hpp"
#include "taut/scene.hpp"

namespace taut::bench {

struct Gas {
  Scene scene;
  std::vector<elastic::RigidBody> bodies;  ///< the walls last
  double side = 0;                         ///< of the box
  std::size_t count = 0;                   ///< without the walls
};

/// Bodies of radius 1 that fill `fraction` of a square box, at random velocities and spins of about 1. Of 6 vertices
/// they are hexagons, of more, stars.
Gas gas(int bodies, int vertices, double fraction);

/// The same of any polygon about the origin. Where the fraction asks for it, bodies stand in staggered rows, and the
/// box is no square: `side` is the width. Throws InputError where they would overlap even so.
Gas gas(int bodies, const Polygon& ring, double fraction);

/// The body, as it is drawn.
Polygon gas_polygon(int vertices);

}  // namespace taut::bench
