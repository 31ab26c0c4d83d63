// The orientation of three displaced vertices of one body: it never changes, and is never zero in general position.
#pragma once

#include "geometry/displacement.hpp"

namespace taut {

/// Which stage decided a sign.
enum class Stage : unsigned char {
  filter,        ///< a double with an error bound
  exact,         ///< exactly, by expansions of doubles
  displacement,  ///< the input was exactly degenerate; the displacement decided, by expansions
};

/// The sign of the orientation of (a, b, c): +1 if they turn left. 0 only if the displaced points are collinear.
int orientation(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c);
/// The same, telling which stage answered.
int orientation(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c, Stage& stage);

}  // namespace taut
