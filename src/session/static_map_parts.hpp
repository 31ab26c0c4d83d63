// The data of maps and movers, for the queries that use them.
#pragma once

#include <string>
#include <vector>

#include "geometry/shape_facts.hpp"
#include "solver/map_search.hpp"
#include "taut/static_map.hpp"

namespace taut {
using namespace internal;

struct StaticMap::Impl {
  std::vector<Body> bodies;
  double largest = 0;  ///< the largest magnitude that a coordinate of a shape may have
  ShapeFacts range;    ///< of magnitudes
  MapBodies prepared;
};

struct StaticMap::Mover::Impl {
  std::string name;
  SharedRings rings;
  Layers z;
  AxisBox bounds;  ///< in the user's units
  double extent = 0;
  const void* map = nullptr;
};

}  // namespace taut
