// The displacement that puts input in general position (DESIGN: "Touching"; section 2.3 of the paper asks for it).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/hull.hpp"

namespace taut {

/// A vertex that is exactly (x + dx, y + dy): the input's point, and a displacement far below its resolution.
struct DisplacedPoint {
  double x, y;
  double dx, dy;
};

/// A polygon of such vertices, never changed: pairs and threads share it.
struct DisplacedPolygon {
  /// `fine_features`: some feature may be smaller than the displacement. Then it must be checked that the displaced
  /// polygon is simple.
  explicit DisplacedPolygon(std::vector<DisplacedPoint> vertices, bool fine_features = false);

  std::vector<DisplacedPoint> points;
  Bounds bounds;       ///< of the points before the displacement
  double largest = 0;  ///< magnitude of their coordinates
  bool fine_features = false;
};
using SharedPolygon = std::shared_ptr<const DisplacedPolygon>;

/// delta, the unit of displacement, for coordinates up to 1 in magnitude.
inline constexpr double displacement_unit = 0x1p-200;

/// Displaces every vertex of a counterclockwise simple polygon so that both its edges move towards the inside
/// (`inwards`) or the outside by between `delta` and 2 `delta`, by an amount that depends only on `seed` and the
/// vertex's index. At a spike sharper than about 2^-40 the tip moves by at most 2^41 delta, which may be less than
/// what its edges ask for.
std::vector<DisplacedPoint> displace(std::span<const Point> polygon, bool inwards, double delta, std::uint64_t seed);

}  // namespace taut
