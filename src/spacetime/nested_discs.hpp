// A disc around a body, and a disc that no edge of a hole enters.
//
// A pin that turns in its bore shows each of its edges to each of the bore's, and boxes along these have to be as small
// as the gap is wide before they are apart. While the disc around the pin is in the one within the bore, they are so,
// however the pin turns.
#pragma once

#include <span>

#include "geometry/displacement.hpp"
#include "geometry/vector.hpp"

namespace taut::internal::spacetime {

struct Disc {
  Vector centre;
  double radius = 0;
};

/// A disc that certainly contains the points, as displaced; nearly the least one.
Disc disc_around(std::span<const DisplacedPoint> points);
/// The disc about the middle of a closed ring that certainly meets none of its edges, as displaced; of radius 0 if
/// there is none.
Disc disc_within(std::span<const DisplacedPoint> ring);

}  // namespace taut::internal::spacetime
