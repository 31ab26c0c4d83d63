// The displacement that puts input in general position, as section 2.3 of the paper asks for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/axis_box.hpp"
#include "numeric/stages.hpp"

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

// The orientation of three displaced vertices of one body: it never changes, and is never zero in general position.

/// The sign of the orientation of (a, b, c): +1 if they turn left. 0 only if the displaced points are collinear.
/// Coordinates are at most 1 in magnitude, and no point is displaced by more than `room`.
int orientation(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                double room = displacement_room);
/// The same, if doubles decide, else 0. If they do, the points before the displacement turn that way, too, and c is
/// farther than 2^7 `room` from the line through a and b: the determinant is more than 2^9 `room`, and ab shorter
/// than 3.
int orientation_in_doubles(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                           double room = displacement_room);
/// The same as the first, and which stage decided.
StagedSign orientation_staged(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c,
                              double room = displacement_room);

// Does a displacement keep its laws?

/// Are all features of the polygon so large that no vertex that moves by less than `farthest` can break the laws of
/// displaced_polygon()? Coordinates are at most 1 in magnitude. Linear time; false is no proof of the contrary.
bool has_room(const std::vector<Point>& polygon, double farthest);

/// Two edges that come so close that the displaced ring meets itself or the ring it was made of, or lies on the wrong
/// side of it. Each corner must keep its own law, and no vertex move by `farthest` or more. Exact; about O(n log n).
std::optional<DisplacementFault> find_displacement_fault(const std::vector<DisplacedPoint>& ring, Offset offset,
                                                         double farthest);

}  // namespace taut::internal
