#include "taut/grid.hpp"
#include "taut/static_map.hpp"

namespace taut {
using namespace internal;

StaticMap StaticMap::from_grid(const OccupancyGrid& grid, double reach) { return StaticMap(grid_bodies(grid), reach); }

StaticMap StaticMap::from_grid(const std::string& yaml_file, double reach) {
  return from_grid(read_grid(yaml_file), reach);
}

}  // namespace taut
