// Plots as SVG, drawn from tables.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace taut::paper {

struct Axis {
  std::string label;
  int base = 10;  ///< logarithmic with this base (2 or 10)
};

struct Series {
  std::string label;
  std::vector<std::pair<double, double>> points;
  bool line = true;     ///< join the points
  bool marks = true;    ///< mark the points
  bool dashed = false;  ///< for bounds and fits
  int colour = -1;      ///< index into the palette; -1: the next one
};

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Series> series;
  int width = 760, height = 460;
};

/// Log-log. Points that are not positive are left out.
std::string draw(const Plot& plot);

}  // namespace taut::paper
