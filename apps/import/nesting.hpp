// Rings that lie in each other, as outlines with holes.
#pragma once

#include <vector>

#include "import/drawing.hpp"

namespace taut::drawing {

/// What a sheet's rings enclose: a part with its holes, and where its outline comes from.
struct NestedPart {
  Part part;
  std::string place;
};

/// Parts of what lies inside by the rule. Rings that change nothing (both of their sides are inside) are counted in
/// `idle`. Rings must not cross; whether they do is for the caller to find out, as of parts they may touch.
std::vector<NestedPart> nest(const std::vector<Chain>& rings, Fill fill, int& idle);

/// Drops points that repeat the one before; false if fewer than three are left, or all on one line.
bool tidy_ring(std::vector<Point>& ring);

}  // namespace taut::drawing
