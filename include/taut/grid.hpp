// Occupancy grids, as robots map their surroundings: cells become polygons with holes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "taut/io.hpp"
#include "taut/scene.hpp"

namespace taut {

/// Which cells of a map are obstacles. Row 0 is the lowest: cell (i, j) is the square between the corners (i, j) and
/// (i + 1, j + 1), where corner (i, j) is at origin + resolution (i, j), turned by `yaw` about the origin; each of
/// these is computed in doubles, once, so that neighbours have their corners in common.
struct OccupancyGrid {
  int width = 0, height = 0;
  double resolution = 1;               ///< the side of a cell
  Point origin;                        ///< the lower left corner of cell (0, 0)
  double yaw = 0;                      ///< radians
  std::vector<std::uint8_t> occupied;  ///< row by row, from the lowest; not 0: an obstacle

  /// Is the cell an obstacle? Beyond the grid there is none.
  bool at(int i, int j) const {
    return i >= 0 && j >= 0 && i < width && j < height && occupied[static_cast<std::size_t>(j) * width + i] != 0;
  }
};

/// A picture in shades of grey, row by row from the highest one, from 0 (black) to 1 (white).
struct GreyImage {
  int width = 0, height = 0;
  std::vector<double> grey;
};

/// How a map of map_server is read.
struct GridOptions {
  /// Are cells that the thresholds call neither free nor occupied obstacles? What was never seen may be anything.
  bool unknown_occupied = true;
  /// Reads images that are not PGM, from the bytes of the file and its name, or gives nothing for those that it does
  /// not know either. The library itself reads PGM only.
  std::function<std::optional<GreyImage>(const std::string& bytes, const std::string& file)> read_image = {};
};

/// A map as ROS's map_server writes it: a YAML file with `image` (a PGM file, P2 or P5, or what GridOptions::read_image
/// reads, found relative to it), `resolution`, `origin` [x, y, yaw], and, if they are there, `negate`,
/// `occupied_thresh` (0.65) and `free_thresh` (0.25). A cell is occupied where its darkness is above occupied_thresh,
/// and unknown where it is not below free_thresh either. Throws InputError with the file, the line, and the remedy.
OccupancyGrid read_grid(const std::string& yaml_file, const GridOptions& options = {}, const ReadLimits& limits = {});

/// The occupied cells as bodies, exactly: one for each set of cells that hang together by their sides, with holes where
/// others are free; cells that meet at a corner alone hang together only if they do so elsewhere. Such corners would
/// make a ring touch itself: one of the two cells is then a part of its own. Corners in the middle of a straight side
/// are left out. Bodies are called "cells 1", "cells 2", ... from the lowest row on. Throws InputError if the grid is
/// not as it should be, or has no occupied cell.
std::vector<Body> grid_bodies(const OccupancyGrid& grid);

}  // namespace taut
