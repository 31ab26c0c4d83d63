// What maps and movers are made of, for those who ask them.
#pragma once

#include <string>
#include <vector>

#include "geometry/shape_facts.hpp"
#include "search/map_search.hpp"
#include "taut/static_map.hpp"

namespace taut {
using namespace internal;

struct StaticMap::Impl {
  std::vector<Body> bodies;
  double largest = 0;  ///< magnitude of a coordinate that shapes may have
  ShapeFacts range;    ///< of magnitudes
  MapBodies prepared;
};

struct StaticMap::Mover::Impl {
  std::string name;
  SharedRings rings;
  Bounds bounds;  ///< in the user's units
  double extent = 0;
  const void* map = nullptr;
};

}  // namespace taut
