// Small things in drawings that were not meant.
#pragma once

#include <vector>

#include "import/faces.hpp"
#include "import/line_graph.hpp"

namespace taut::drawing {

/// Something small that was cut off or filled.
struct Repair {
  enum class Kind { loop, sliver, crossing, spike };
  Kind kind = Kind::loop;
  Point at;
  double size = 0;         ///< of a sliver its width, else the extent
  std::size_t source = 0;  ///< index of a chain
};

/// Edges of blocks that are no larger than `size`, and hang on a larger one by a node or by other such blocks, are no
/// longer alive. False if there are none.
bool cut_loops(const LineGraph& graph, std::vector<bool>& alive, double size, std::vector<Repair>& repairs);

/// Edges that hang on others by one end, so that a ring goes to and fro along them, are no longer alive.
void cut_spikes(const LineGraph& graph, std::vector<bool>& alive, std::vector<Repair>& repairs);

/// A line that is drawn twice, with copies that cross or meet at their ends only, is a cycle narrower than half of
/// `join` and larger than `size`, in a block of its own. One of the copies is no longer alive, so that the other one
/// still leads from end to end.
void thin_doubled_lines(const LineGraph& graph, std::vector<bool>& alive, double join, double size,
                        std::vector<Repair>& repairs);

/// Joins faces to the one with which they share most of their boundary: those that are narrower than half of `join`,
/// between lines that are meant to be one, and those that are no larger than `size`, at a larger block. `faces` are
/// those of the edges that are alive; edges between joined ones no longer are. False if there was nothing to do.
bool dissolve_small_faces(const LineGraph& graph, std::vector<bool>& alive, const FaceMap& faces, double join,
                          double size, std::vector<Repair>& repairs);

}  // namespace taut::drawing
