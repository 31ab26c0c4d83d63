// Parts of one body that lie on each other.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "import/outlines.hpp"

namespace taut::drawing {

/// A part, and what it was made of. Parts of one source do not overlap.
struct SourcedPart {
  const Part* part;
  int source;
  bool lines;  ///< drawn as lines, not filled
};

/// What overlapping parts have in common.
struct Overlaps {
  double area = 0;  ///< by which the areas of the parts exceed that of their union
  /// Indices of parts that lie in another one: drawn as lines in a filled one, the other way round, and both filled.
  std::vector<std::size_t> lines_in_filled, filled_in_lines, filled_in_filled;
};

Overlaps overlaps_of(const std::vector<SourcedPart>& parts, const OutlineSettings& settings);

}  // namespace taut::drawing
