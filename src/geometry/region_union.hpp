// Unions: of closed rings in general position, and of many polygons, rounded to a grid.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Collects polygons, and unites those that came one after the other first: of what a moving body covers, most is
/// inside of what it has covered just before.
///
/// Vertices are rounded to the nearest points of the grid, and so is where edges cross, at each union that an edge goes
/// through: it moves by at most one and a half grid units each time.
class RegionUnion {
 public:
  /// The grid is a power of two. Only what is near `near` has room on it, and coordinates are less than 2^52 of it.
  RegionUnion(double grid, const Point& near);
  ~RegionUnion();

  /// No polygon goes through more unions. Four times 2^18 polygons, a million, are united in so many.
  static constexpr int most_unions = 20;
  /// No edge moves farther.
  static constexpr double most_moved_in_grids = 1.5 * most_unions + 1;
  /// May polygons with the point be added? Yes if it is within 2^27 of the grid of `near`.
  bool has_room_for(const Point& p) const;

  /// A polygon whose vertices run counterclockwise.
  void add(const Polygon& polygon);
  void add(const Part& part);
  /// The union. No rings meet, not even at points. Nothing may be added afterwards. Throws InputError if there were too
  /// many polygons.
  std::vector<Part> parts();

 private:
  struct Levels;
  std::unique_ptr<Levels> levels_;
};

// The union of closed rings in general position.

/// A vertex of a union's boundary: one of a ring, or where two edges cross, rounded.
struct UnionVertex {
  Point at;
  std::uint32_t ring = 0, edge = 0;  ///< the edge of a ring that leaves from here, by its first vertex
};

/// The boundary of the points that the rings wind around at least once in sum, with these points to the left of it.
struct RingUnion {
  std::vector<std::vector<UnionVertex>> rings;
  bool changed = false;  ///< it is not just the rings themselves
};

/// Outlines run counterclockwise and holes clockwise; a ring may cross itself and others. Exact but for the rounding of
/// crossings. Nothing if the rings are not in general position: three edges meet in a point, or a vertex lies on an
/// edge.
std::optional<RingUnion> union_of(const std::vector<Polygon>& rings);

}  // namespace taut::internal
