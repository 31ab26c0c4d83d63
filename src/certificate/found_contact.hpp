// A contact found by an engine, in the engine's own terms.
#pragma once

#include <optional>

#include "certificate/precise_time.hpp"
#include "geometry/ids.hpp"

namespace taut::internal {

/// A vertex that is on an edge of the other polygon, and the time. The edge is given by its first vertex,
/// counterclockwise, and the time by an enclosure of the segment's parameter.
struct FoundContact {
  VertexId vertex, edge;
  double lo = 0, hi = 0;
  /// A tighter enclosure of this instant alone, if doubles do not distinguish it from others in [lo, hi].
  std::optional<PreciseTime> at = {};
};

}  // namespace taut::internal
