// The tilings of near pairs as lines in the world.
#pragma once

#include <string>
#include <vector>

#include "io/svg_canvas.hpp"
#include "io/world_shapes.hpp"
#include "taut/simulation.hpp"

namespace taut::internal::io {

struct TilingLine {
  Point from, to;
  bool pq = false;  ///< joins two bodies
};

/// Each line once. Tilings of rings that are farther from each other than the smaller one is large are left out: they
/// say little, and a body of many parts has many.
std::vector<TilingLine> tiling_lines(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                                     const std::vector<NearTiling>& tilings);

/// The same as paths of a picture.
std::string tiling_paths(const std::vector<TilingLine>& lines, const SvgCanvas& canvas);

}  // namespace taut::internal::io
