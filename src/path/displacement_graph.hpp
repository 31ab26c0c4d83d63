// Shortest ways of a point among open convex polygons in a convex polygon, by exact signs.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "path/exact_point.hpp"

namespace taut::internal::path {

/// The sum of a convex polygon and another one mirrored at the origin, moved by `offset`: all displacements of `mover`
/// at which it overlaps `rest`.
ConvexRing forbidden(const Polygon& rest, const Polygon& mover, const Dyadic& offset_x, const Dyadic& offset_y);
/// Rounded.
double distance(const ExactPoint& a, const ExactPoint& b);
/// Larger about its middle by this share; nothing if the middle, rounded, is not inside.
std::optional<ConvexRing> enlarged_by(const ConvexRing& ring, const Dyadic& share);

/// Where a way may end: in a closed convex set, a point or a segment perhaps, that is within the range, but not in open
/// polygons.
struct DisplacementGoal {
  ConvexRing region;
  std::vector<ConvexRing> excluded = {};

  bool contains(const ExactPoint& p) const;
};

class DisplacementGraph {
 public:
  /// The range may be a segment or a point.
  DisplacementGraph(std::vector<ConvexRing> obstacles, ConvexRing range);

  /// The shortest way from a point of the range to the goal, if there is any: it turns at vertices of obstacles only,
  /// and is within the range. Segments may run along obstacles.
  std::optional<std::vector<ExactPoint>> way(const ExactPoint& from, const DisplacementGoal& goal) const;

 private:
  using Edge = std::array<ExactPoint, 2>;
  bool is_free(const ExactPoint& p) const;
  bool passes(const ExactPoint& a, const ExactPoint& b) const;
  std::vector<ExactPoint> entries(const DisplacementGoal& goal, const std::vector<Edge>& edges) const;
  bool is_entry(const ExactPoint& p, const DisplacementGoal& goal) const;

  std::vector<ConvexRing> obstacles_;
  std::vector<AxisBox> boxes_;
  ConvexRing range_;
  std::vector<ExactPoint> corners_;
};

}  // namespace taut::internal::path
