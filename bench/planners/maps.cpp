#include "planners/maps.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "peers/convex_pieces.hpp"
#include "taut/grid.hpp"
#include "taut/io.hpp"

namespace taut::bench {
namespace {

using Random = std::mt19937;

/// The same everywhere, unlike the distributions of std::.
double share(Random& random) { return static_cast<double>(random()) / 4294967296.0; }

Polygon rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

void add_body(PlanMap& map, const Polygon& outline) {
  map.bodies.push_back({"obstacle " + std::to_string(map.bodies.size() + 1), outline, {}});
  for (Polygon& piece : convex_pieces(outline, 8)) map.pieces.push_back(std::move(piece));
}

void set_robot(PlanMap& map, const Polygon& outline) {
  map.robot = {"robot", outline, {}};
  map.robot_pieces = convex_pieces(outline, 8);
}

/// A T whose bars are an eighth as wide as it is long.
Polygon tee(double size) {
  const double w = size / 16, l = size / 2;
  return {{-w, -l}, {w, -l}, {w, l - 2 * w}, {l, l - 2 * w}, {l, l}, {-l, l}, {-l, l - 2 * w}, {-w, l - 2 * w}};
}

/// A room of 10 m by 10 m with walls of 4 cm, each with a gap.
PlanMap walls() {
  PlanMap map;
  map.name = "walls";
  map.lo = {0, 0};
  map.hi = {10, 10};
  for (int k = 1; k < 5; ++k) {
    const double x = 2 * k, gap = k % 2 == 1 ? 7.6 : 1.2;
    add_body(map, rectangle(x, -1, x + 0.04, gap));
    add_body(map, rectangle(x, gap + 1.2, x + 0.04, 11));
    add_body(map, rectangle(x - 1.3, 5, x - 0.7, 5.04));
  }
  set_robot(map, tee(0.8));
  map.start = {1, 2, 0};
  map.goal = {9.2, 8, 1.5};
  return map;
}

/// Stars of 7 to 14 points.
PlanMap random_polygons() {
  PlanMap map;
  map.name = "polygons";
  map.lo = {0, 0};
  map.hi = {10, 10};
  Random random(7);
  for (int k = 0; k < 81; ++k) {
    const Point at{0.9 + 1.05 * (k % 9) - 0.2 * share(random), 0.9 + 1.05 * (k / 9) - 0.2 * share(random)};
    const int points = 7 + static_cast<int>(8 * share(random));
    Polygon star;
    for (int i = 0; i < points; ++i) {
      const double angle = 6.283185307179586 * i / points, radius = 0.12 + 0.26 * share(random);
      star.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
    }
    add_body(map, star);
  }
  set_robot(map, tee(0.5));
  map.start = {0.3, 0.3, 0};
  map.goal = {9.7, 9.7, 0};
  return map;
}

/// Of a grid, with one rectangle for each run of cells in a row.
void add_grid(PlanMap& map, const OccupancyGrid& grid) {
  map.bodies = grid_bodies(grid);
  const double r = grid.resolution;
  for (int j = 0; j < grid.height; ++j) {
    for (int i = 0, from = 0; i <= grid.width; ++i) {
      if (grid.at(i, j)) continue;
      if (from < i) map.pieces.push_back(rectangle(from * r, j * r, i * r, (j + 1) * r));
      from = i + 1;
    }
  }
  map.lo = {0, 0};
  map.hi = {grid.width * r, grid.height * r};
}

void fill(OccupancyGrid& grid, int x0, int y0, int x1, int y1, int value) {
  for (int j = y0; j < y1; ++j) {
    for (int i = x0; i < x1; ++i) grid.occupied[static_cast<std::size_t>(j * grid.width + i)] = value != 0;
  }
}

OccupancyGrid free_grid(int width, int height, double resolution) {
  OccupancyGrid grid;
  grid.width = width;
  grid.height = height;
  grid.resolution = resolution;
  grid.occupied.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  return grid;
}

/// A storey of 24 m by 16 m in cells of 10 cm: two rows of rooms at a corridor, a door of 1 m in each, tables inside.
PlanMap office() {
  PlanMap map;
  map.name = "office";
  OccupancyGrid grid = free_grid(240, 160, 0.1);
  fill(grid, 0, 0, 240, 160, 1);
  fill(grid, 2, 70, 238, 90, 0);
  for (int k = 0; k < 6; ++k) {
    const int x = 2 + 40 * k, wide = k == 5 ? 36 : 38;
    for (const bool upper : {false, true}) {
      const int y = upper ? 92 : 2;
      fill(grid, x, y, x + wide, y + 66, 0);
      const int door = x + 4 + 5 * (k % 4);
      fill(grid, door, upper ? 90 : 68, door + 10, upper ? 92 : 70, 0);
      fill(grid, x + 14, y + 28, x + 26, y + 36, 1);
      fill(grid, x + 6, y + 48, x + 10, y + 52, 1);
    }
  }
  add_grid(map, grid);
  set_robot(map, tee(0.8));
  map.start = {1.5, 1.5, 0};
  map.goal = {22, 14.5, 1};
  return map;
}

/// Corridors 1.2 m wide between walls of 30 cm, made by a walk that never comes back to where it was.
PlanMap maze() {
  constexpr int size = 6, step = 15, wall = 3;
  PlanMap map;
  map.name = "maze";
  OccupancyGrid grid = free_grid(size * step + wall, size * step + wall, 0.1);
  fill(grid, 0, 0, grid.width, grid.height, 1);
  Random random(3);
  std::vector<std::pair<int, int>> way{{0, 0}};
  std::vector<bool> seen(size * size, false);
  const auto open = [&](int x, int y, int u, int v) {
    fill(grid, wall + step * std::min(x, u), wall + step * std::min(y, v), step * (std::max(x, u) + 1),
         step * (std::max(y, v) + 1), 0);
  };
  seen[0] = true;
  open(0, 0, 0, 0);
  while (!way.empty()) {
    const auto [x, y] = way.back();
    std::vector<std::pair<int, int>> next;
    for (const auto& [u, v] : {std::pair(x + 1, y), std::pair(x - 1, y), std::pair(x, y + 1), std::pair(x, y - 1)}) {
      if (u >= 0 && v >= 0 && u < size && v < size && !seen[static_cast<std::size_t>(v * size + u)])
        next.emplace_back(u, v);
    }
    if (next.empty()) {
      way.pop_back();
      continue;
    }
    const auto [u, v] = next[random() % next.size()];
    seen[static_cast<std::size_t>(v * size + u)] = true;
    open(x, y, u, v);
    way.emplace_back(u, v);
  }
  add_grid(map, grid);
  set_robot(map, tee(0.6));
  map.start = {0.9, 0.9, 0};
  map.goal = {8.4, 8.4, 0};
  return map;
}

/// The Trondheimsfjord in kilometres; the ship is 5 km long, so that she has to look where she goes.
PlanMap harbour(const std::string& folder) {
  PlanMap map;
  map.name = "harbour";
  for (const Part& part : read_wkt_parts(folder + "/trondheimsfjord.wkt")) {
    Polygon land = part.outline;
    for (Point& p : land) p = {(p.x + 450000) / 1000, (p.y + 135000) / 1000};
    add_body(map, land);
  }
  map.lo = {0, 0};
  map.hi = {150, 140};
  set_robot(map, {{-2.5, -0.4}, {1.7, -0.4}, {2.5, 0}, {1.7, 0.4}, {-2.5, 0.4}});
  map.start = {20, 90, 0};
  map.goal = {122, 88.5, 0.5};
  return map;
}

}  // namespace

std::vector<PlanMap> plan_maps(const std::string& folder) {
  return {walls(), random_polygons(), office(), maze(), harbour(folder)};
}

}  // namespace taut::bench
