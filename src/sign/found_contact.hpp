// What an engine found, in the engine's own terms.
#pragma once

#include <optional>

#include "geometry/ids.hpp"
#include "sign/precise_time.hpp"

namespace taut::internal {

/// Where and when a vertex is on an edge of the other polygon: the edge by its first vertex, counterclockwise, and an
/// enclosure of the segment's parameter.
struct FoundContact {
  VertexId vertex, edge;
  double lo = 0, hi = 0;
  /// Where doubles did not tell this instant from others, some of which [lo, hi] may contain: it alone.
  std::optional<PreciseTime> at = {};
};

}  // namespace taut::internal
