// Observing the events of a kinetic simulation.
#pragma once

#include <cstdint>

#include "taut/feature.hpp"

namespace taut {

/// How a failed certificate was repaired (Fig. 7 of the paper, and the degenerate forms around it).
enum class Repair : std::uint8_t {
  convex_flip,      ///< a convex corner closed: one edge is replaced by a shorter one
  convex_triangle,  ///< a triangle closed and vanished
  reflex_new_face,  ///< a reflex corner straightened: a new triangle appears, case (a)
  reflex_right,     ///< case (b): the edge after the corner is replaced
  reflex_left,      ///< case (c): the edge before the corner is replaced
  collision,        ///< a vertex reached a polygon edge
};

/// "convex_flip", "convex_triangle", "reflex_a", "reflex_b", "reflex_c" or "collision".
const char* to_string(Repair repair);

/// One certificate failure: the corner u -> v -> w of a face degenerated within [lo, hi].
struct TraceEvent {
  std::uint64_t number = 0;  ///< 1 for the first event
  double lo = 0, hi = 0;     ///< enclosure of the failure time
  bool bridging = false;     ///< at a joint of two motion pieces, while the jump was bridged
  Repair repair = Repair::collision;
  VertexRef u, v, w;
  bool pinch_rule = false;         ///< a pinch edge decided the case
  bool three_corners = false;      ///< all three corners of a triangle failed at once
  int corners_touched = 0;         ///< corners that the repair may have changed: a small constant
  std::uint64_t certificates = 0;  ///< size of the active set after the repair
};

/// Told of what happens, in order of time.
class Tracer {
 public:
  virtual ~Tracer() = default;
  /// Called once for every event, after its repair.
  virtual void on_event(const TraceEvent& event) = 0;
};

}  // namespace taut
