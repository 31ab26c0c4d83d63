// Shortest ways of a point among open convex polygons in a rectangle, by exact signs.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/axis_box.hpp"
#include "numeric/dyadic.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::path {

/// A point of the plane, exactly.
struct ExactPoint {
  Dyadic x, y;
  Point near;  ///< rounded

  static ExactPoint of(Dyadic x, Dyadic y) {
    const Point near{nearest_double(x), nearest_double(y)};
    return {std::move(x), std::move(y), near};
  }
  bool is_double() const { return x == Dyadic::exact(near.x) && y == Dyadic::exact(near.y); }
};

/// The sign of (b - a) x (c - a). Exact.
int orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);

/// An open convex polygon, counterclockwise; corners may be flat.
using Obstacle = std::vector<ExactPoint>;

/// The sum of a convex polygon and another one mirrored at the origin, moved by `offset`: all displacements of `mover`
/// at which it overlaps `rest`. Larger about its middle by `growth`.
Obstacle forbidden(const Polygon& rest, const Polygon& mover, const Dyadic& offset_x, const Dyadic& offset_y,
                   const Dyadic& growth);

class DisplacementGraph {
 public:
  DisplacementGraph(std::vector<Obstacle> obstacles, const AxisBox& range);

  /// The shortest way from a point to one of others, if there is any: corners at vertices of obstacles, all within the
  /// range. Segments may run along obstacles.
  std::optional<std::vector<ExactPoint>> way(const ExactPoint& from, const std::vector<ExactPoint>& goals) const;

 private:
  bool is_free(const ExactPoint& p) const;
  bool passes(const ExactPoint& a, const ExactPoint& b) const;

  std::vector<Obstacle> obstacles_;
  std::vector<AxisBox> boxes_;
  std::vector<ExactPoint> corners_;
};

}  // namespace taut::internal::path
