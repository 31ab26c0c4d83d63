// Which cells of bands meet?
#pragma once

#include <array>
#include <vector>

#include "geometry/band.hpp"

namespace taut::internal::curve {

/// A cell of one of several bands.
struct CellId {
  int band = 0, cell = 0;
};

/// All pairs of cells that meet elsewhere than neighbours may, in their gate; by exact signs, about O(n log n) where
/// few meet.
std::vector<std::array<CellId, 2>> meeting_cells(const std::vector<const Band*>& bands);

}  // namespace taut::internal::curve
