// Extending a line of sight to where it ends, and what lies behind it.
#pragma once

#include <cstddef>
#include <vector>

#include "tiling/hourglass.hpp"
#include "tiling/sleeve.hpp"

namespace taut::internal {

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
