// What the drawings of the figures share.
#pragma once

#include <string>
#include <vector>

#include "taut/io.hpp"
#include "taut/simulation.hpp"

namespace taut::paper {

/// A picture on a sheet: no legend, no title (its caption stands on the sheet).
TilingDrawOptions panel_options();
/// A simulation that stands at t.
Simulation at(const Scene& scene, double t);
const Point& position(const Tiling& tiling, int v);
/// The vertex of a body with this index of the input.
int find_vertex(const Tiling& tiling, int body, int index);
/// A place beside a vertex, outside its body (or inside, for a negative distance), for a letter.
Point outwards(const Scene& scene, const Tiling& tiling, int v, double distance);

// Figures that show placements, and those that show events; one file each.
std::string figure_1(const Scene& scene);
std::string figure_2(const Scene& scene);
std::string figure_3(const Scene& scene);
std::string figure_4(const Scene& scene);
std::string figure_5(const Scene& scene);
std::string figure_7(const Scene& scene);
std::string figure_8(const Scene& inner, const Scene& outer);
std::string figure_16(const Scene& scene);
std::string figure_17(const Scene& scene);

}  // namespace taut::paper
