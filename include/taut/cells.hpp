// Which cells of a grid does a moving body touch? Motion primitives of grid planners.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "taut/feature.hpp"
#include "taut/limits.hpp"
#include "taut/scene.hpp"

namespace taut {

/// The grid: cell (i, j) is the closed square from origin + resolution (i, j) to origin + resolution (i + 1, j + 1), of
/// exact numbers.
struct CellOptions {
  double resolution = 0;  ///< the side of a cell, in units of the scene; must be given
  Point origin = {};
  Limits limits = {};
};

/// What cells() found.
struct CoveredCells {
  double resolution = 0;
  Point origin = {};
  /// By column and row: in order of rows, then of columns.
  std::vector<std::array<int, 2>> cells;
};

/// All cells that the body, its boundary included, touches at any instant of the scene's time, wherever its motion and
/// its parents' motions put it: none is missing, whatever happens between poses. And hardly more: every cell in the
/// answer is at most a sixteenth of a cell away from the body at some instant. Other bodies do not matter. Throws
/// InputError if the scene is not valid, if there is no such body, if a cell is so small that doubles do not decide
/// sixteenths of it where the body is, or if there would be more than 2^26 cells; UndecidedError if it is stopped.
CoveredCells cells(const Scene& scene, BodyId body, const CellOptions& options);

/// {"body": name, "resolution": r, "origin": [x, y], "cells": [[i, j], ...]} on one line, and before the cells the
/// "lock" of a mechanism, until which they are.
std::string cells_json(const Scene& scene, BodyId body, const CoveredCells& covered);
/// An image (PGM, P5), a pixel for each cell of the rectangle around them, the highest row first: covered cells are
/// black (0), others are white (254). Empty if there is no cell.
std::string cells_pgm(const CoveredCells& covered);
/// What map_server, and read_grid() of taut/grid.hpp, need besides that image: a map of the covered cells.
std::string cells_yaml(const CoveredCells& covered, const std::string& image_file);

}  // namespace taut
