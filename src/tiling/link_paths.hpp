// Separators with the fewest links, by greedy choice of windows.
#pragma once

#include <cstddef>
#include <vector>

#include "tiling/sleeve.hpp"

namespace taut::internal {

/// A separator as the lines of its links, in order; where two neighbours meet is a vertex. Of a closed one, the last
/// meets the first; of an open one, the first and the last run to infinity.
struct LinkPath {
  std::vector<DirectedLine> lines;
  bool closed = false;
};

/// How many links a separator needs, and one that has about as many: its vertices are subject to rounding.
struct LinkBound {
  int lower = 0;  ///< certain: no separator of the class has fewer
  LinkPath path;
};

/// The open separators: from infinity to infinity. The path has exactly as many links as `lower`.
LinkBound open_link_bound(const Arena& arena);

/// The closed ones around polygon `owner` (0 or 1). The path has `lower` links if RCH(owner) has an edge to the other
/// polygon, and at most one more otherwise. Empty path if the class need not be searched: the other polygon lies in a
/// pocket of this one, and a curve around the other one is no longer.
LinkBound closed_link_bound(const Arena& arena, int owner);

/// Over all separators.
LinkBound link_bound(const Arena& arena);

/// A line of sight that touches the free space's left and right side as far as it can see ends at the other side. From
/// its last touching point (the foot) to that end (the head) it is a window: beyond it, the next link begins.
struct Window {
  DirectedLine line;
  /// What the window sees up to the first gate behind it, both included: on the side of the foot from the foot on, on
  /// that of the head from the head on.
  std::vector<Point> left, right;
  std::size_t last = 0;  ///< the last gate (its index) that the line crosses
};

/// The line passes gate `g`, and leaves its triangle by the side: the next gate's new left (or right) end blocks it.
/// `foot_side` holds the points from the foot on, on the other side.
///
/// The head is rounded to doubles away from the foot and forward, so that no curve gets by in front of the window:
/// counts of links from there on are lower bounds. It lies outside the free space, by rounding errors.
Window open_window(const Arena& arena, const DirectedLine& line, std::vector<Point> foot_side, Gate g,
                   bool blocked_by_left);

}  // namespace taut::internal
