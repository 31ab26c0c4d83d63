// Arcs as SVG gives them, by their ends, and as geometry wants them, around a centre.
#pragma once

#include <optional>

#include "geometry/piece.hpp"

namespace taut::internal::curve {

struct CentredArc {
  ArcFrame frame;
  std::array<WidePoint, 2> unit;  ///< where it begins and ends, on the unit circle
};

/// Appendix B.2.4 of SVG 2, with a bound of every error; radii are positive, the ends differ.
CentredArc centred(const Point& from, const ArcTo& arc);

}  // namespace taut::internal::curve
