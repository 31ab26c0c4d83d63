// Small things in drawings that were not meant.
#pragma once

#include <vector>

#include "import/line_graph.hpp"

namespace taut::drawing {

/// Something small that was cut off or filled.
struct Repair {
  enum class Kind { loop, sliver, crossing };
  Kind kind = Kind::loop;
  Point at;
  double size = 0;         ///< of a sliver its width, else the extent
  std::size_t source = 0;  ///< index of a chain
};

/// Edges of blocks that are no larger than `size`, and hang on a larger one by a node or by other such blocks, are no
/// longer alive. False if there are none.
bool cut_loops(const LineGraph& graph, std::vector<bool>& alive, double size, std::vector<Repair>& repairs);

/// Cuts loops; and where there are none, joins faces to the one with which they share most of their boundary: those
/// that are narrower than half of `join`, between lines that are meant to be one, and those that are no larger than
/// `size`, at a larger block. False if there was nothing to do.
bool mend_lines(const LineGraph& graph, std::vector<bool>& alive, double join, double size,
                std::vector<Repair>& repairs);

}  // namespace taut::drawing
