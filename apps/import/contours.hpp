// Which lines of a drawing make closed contours by themselves.
#pragma once

#include <utility>
#include <vector>

#include "import/line_graph.hpp"

namespace taut::drawing {

/// Closed contours.
struct Contours {
  std::vector<bool> edges;              ///< of the graph: is the edge on a contour?
  std::vector<std::vector<int>> rings;  ///< the half-edges along each contour
};

/// Strands that are closed, or become closed since exactly two ends meet at each of theirs. `alive` are the edges that
/// count.
Contours contours_of(const LineGraph& graph, const std::vector<bool>& alive);

/// Where a contour crosses or touches itself: the least such node of each ring that does, and the ring's number.
std::vector<std::pair<int, std::size_t>> self_meetings(const LineGraph& graph, const Contours& contours);

}  // namespace taut::drawing
