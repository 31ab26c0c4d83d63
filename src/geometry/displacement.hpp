// The displacement that puts input in general position, as section 2.3 of the paper asks for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/axis_box.hpp"

namespace taut::internal {

/// The side to which a body is displaced: into its material, or away from it.
enum class Offset : std::uint8_t { inward, outward };
inline Offset opposite(Offset offset) { return offset == Offset::inward ? Offset::outward : Offset::inward; }
inline std::size_t index_of(Offset offset) { return static_cast<std::size_t>(offset); }

/// A vertex that is exactly (x + dx, y + dy): the input's point, and a displacement far below its resolution.
struct DisplacedPoint {
  double x, y;
  double dx, dy;
};

/// Why a polygon cannot be displaced: it has a feature that is finer than the displacement.
struct DisplacementFault {
  enum class Kind : std::uint8_t {
    sharp_corner,  ///< at vertex `first`: its edges leave no room for a displacement in doubles
    close_edges,   ///< edges `first` and `second`, each named by its first vertex, come too close
  };
  Kind kind = Kind::sharp_corner;
  std::uint32_t first = 0, second = 0;
};

/// One of several rings of a body: a run of its vertices, with the material to the left.
struct RingSpan {
  std::uint32_t first = 0, count = 0;
  bool hole = false;
};

/// A polygon of such vertices, or the rings of a body, never changed: pairs and threads share it.
struct DisplacedPolygon {
  explicit DisplacedPolygon(std::vector<DisplacedPoint> vertices, std::optional<DisplacementFault> found = {});
  /// Holes come after the outline of their part.
  DisplacedPolygon(std::vector<DisplacedPoint> vertices, std::vector<RingSpan> spans);

  std::vector<DisplacedPoint> points;
  /// Empty if all vertices are one ring.
  std::vector<RingSpan> rings;
  /// Of each vertex, along its ring; empty like `rings`.
  std::vector<std::uint32_t> next, previous;
  AxisBox bounds;      ///< of the points before the displacement
  double largest = 0;  ///< magnitude of their coordinates
  /// The laws below do not hold: nothing may be asked of this polygon.
  std::optional<DisplacementFault> fault;
};
using SharedPolygon = std::shared_ptr<const DisplacedPolygon>;

/// Its rings, also of one that is a single ring and has no table of them.
inline std::vector<RingSpan> rings_of(const DisplacedPolygon& body) {
  if (!body.rings.empty()) return body.rings;
  return {{0, static_cast<std::uint32_t>(body.points.size()), false}};
}

/// delta, the unit of displacement, for coordinates up to 1 in magnitude.
inline constexpr double displacement_unit = 0x1p-200;
/// No coordinate of a vertex is displaced by more.
inline constexpr double displacement_limit = 0x1p-156;
/// What bounds in doubles allow for the displacement, per unit of the coordinates that it is multiplied with.
inline constexpr double displacement_room = 0x1p-150;

/// A number that depends on the key alone, the same on every platform.
double random_between(std::uint64_t key, double lo, double hi);

struct Displacement {
  std::vector<DisplacedPoint> points;
  double farthest = 0;                     ///< more than the way of any vertex
  std::optional<std::uint32_t> too_sharp;  ///< a corner without a displacement in doubles; its vertex stays in place
};

/// Displaces every vertex of a counterclockwise simple polygon towards the inside (`offset`) or the outside, by an
/// amount that depends only on `seed` and the vertex's index. Where `too_sharp` is empty, both edges of each vertex
/// move by between `delta` and 2 `delta` there, to the side asked for, and so do all their points in between.
///
/// Corners are too sharp below about 2^-42 radians. Vertices in line are none.
Displacement displace(std::span<const Point> polygon, Offset offset, double delta, std::uint64_t seed);

/// The polygon displaced by `displacement_unit`, with these laws, or a fault. Coordinates are at most 1 in magnitude.
/// 1. The displaced ring is simple and counterclockwise.
/// 2. It lies in the interior of the polygon (inwards), or the polygon in its interior (outwards).
/// 3. Each of its edges lies between delta and 2 delta to that side of the line of the polygon's edge, and each vertex
///    within `displacement_limit` of the polygon's, in each coordinate.
/// Hence what bodies displaced inwards do, the bodies do; and what the bodies do, those displaced outwards do.
SharedPolygon displaced_polygon(const std::vector<Point>& polygon, Offset offset, std::uint64_t seed);

}  // namespace taut::internal
