// Which lines of a drawing make closed contours by themselves.
#pragma once

#include <vector>

#include "import/line_graph.hpp"

namespace taut::drawing {

/// The edges of strands that are closed, or become closed since exactly two ends meet at each of theirs. `alive` are
/// the edges that count.
std::vector<bool> contour_edges(const LineGraph& graph, const std::vector<bool>& alive);

}  // namespace taut::drawing
