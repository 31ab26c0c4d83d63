#include "taut/grid.hpp"
#include "taut/static_map.hpp"

namespace taut {

StaticMap StaticMap::from_grid(const OccupancyGrid& grid, double reach) { return StaticMap(grid_bodies(grid), reach); }

}  // namespace taut
