// The tilings of near pairs as lines in the world.
#pragma once

#include <string>
#include <vector>

#include "draw/svg_canvas.hpp"
#include "draw/world_shapes.hpp"
#include "taut/simulation.hpp"

namespace taut::internal::io {

/// A vertex in the world.
Point place_of(const WorldShapes& shapes, const std::vector<BodyPose>& poses, const VertexRef& v);

/// Each line once. Tilings of rings that are farther from each other than the smaller one is large are left out, except
/// the only one of two bodies: they show little, and a body of many parts has many.
std::vector<NearEdge> tiling_lines(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                                   const std::vector<NearTiling>& tilings);

/// Those lines that join two bodies, or the others, as the data of a path, where the bodies are at `poses`.
std::string tiling_path(const WorldShapes& shapes, const std::vector<BodyPose>& poses,
                        const std::vector<NearEdge>& lines, bool pq, const SvgCanvas& canvas);

/// The element of such a path. `inside`: what it holds.
std::string tiling_element(const std::string& path, bool pq, const std::string& inside = "");

}  // namespace taut::internal::io
