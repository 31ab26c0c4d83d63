// Is the curve in its cell?
#pragma once

#include "geometry/cell.hpp"

namespace taut::internal::curve {

/// C1 to C4 of cell.hpp, for a piece that is not a line.
bool verified(const Cell& cell, const Gate& first, const Gate& last);

}  // namespace taut::internal::curve
