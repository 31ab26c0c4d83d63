// Ends of lines that do not quite meet.
#pragma once

#include <string>
#include <vector>

#include "import/line_graph.hpp"

namespace taut::drawing {

/// An end of a line that was moved to where it was meant to be.
struct Gap {
  Point from, to;
  double width = 0;
  std::size_t source = 0;  ///< index of the chain
};

/// Moves ends of strands that are at most `join` from each other, or from another line, to one place: first ends
/// that are all near to each other to one of them, then ends to the nearest node or line. What a line itself leads to
/// within a short way does not count. What is moved is added to `gaps`. Ends that go at most so far beyond another line
/// are cut back to it. False if there was nothing to do.
bool close_gaps(std::vector<Strand>& strands, const LineGraph& graph, double join, std::vector<Gap>& gaps);

}  // namespace taut::drawing
