// Separators with the fewest links, by greedy choice of windows.
#pragma once

#include <vector>

#include "tiling/hourglass.hpp"
#include "tiling/separator_arena.hpp"

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

}  // namespace taut::internal
