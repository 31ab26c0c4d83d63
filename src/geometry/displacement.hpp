// The displacement that puts input in general position (DESIGN: "Touching"; section 2.3 of the paper asks for it).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "taut/geometry.hpp"

namespace taut {

/// A vertex that is exactly (x + dx, y + dy): the input's point, and a displacement far below its resolution.
struct DisplacedPoint {
  double x, y;
  double dx, dy;
};

/// delta, the unit of displacement, for coordinates up to 1 in magnitude.
inline constexpr double displacement_unit = 0x1p-200;

/// Displaces every vertex of a counterclockwise simple polygon so that both its edges move towards the inside
/// (`inwards`) or the outside by between `delta` and 2 `delta`, by an amount that depends only on `seed` and the
/// vertex's index. At a spike sharper than about 2^-40 the tip moves by at most 2^41 delta, which may be less than
/// what its edges ask for.
std::vector<DisplacedPoint> displace(std::span<const Point> polygon, bool inwards, double delta, std::uint64_t seed);

}  // namespace taut
