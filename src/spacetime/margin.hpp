// When do two bodies first come closer than a margin? Branch over time and pairs of boxes, in order of time.
#pragma once

#include "spacetime/first_contact.hpp"

namespace taut::spacetime {

/// What is known about two bodies' distance and a margin, along the legs.
struct MarginResult {
  enum Outcome : unsigned char {
    free,       ///< proved: never closer than the margin
    close,      ///< certainly closer at `hi`, and not before `lo`
    undecided,  ///< not closer before `lo`; there they come as close as the margin, as far as doubles tell
  };
  Outcome outcome = free;
  std::size_t leg = 0;
  double lo = 0, hi = 0;    ///< of that leg's parameter
  VertexId edge_p, edge_q;  ///< if `close`: the edges that are, by their first vertices
  double distance = 0;      ///< of these at `hi`: no less than the bodies' distance then
};

/// Up to the end of the window. The bodies must not overlap at its start: those that come to, come closer than any
/// margin before. The margin is in internal units, and positive.
MarginResult first_closer(const PairGeometry& geometry, const TreePair& trees, const std::vector<Leg>& legs,
                          double margin, double until);

}  // namespace taut::spacetime
