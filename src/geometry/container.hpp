// A hole as a polygon: the material around it, with a slit, so that what is in the hole is outside of a simple polygon.
#pragma once

#include <optional>
#include <span>

#include "geometry/displacement.hpp"

namespace taut::internal {

/// The tiling is between two simple polygons. Material around a hole is none, until it is cut open: from one vertex of
/// the hole, its mouth, a wedge of free space widens to the outside of a box. At the mouth it is 2^-40 times as wide as
/// the vertex is displaced. So what the displacement decides is not touched by it, and no vertex of a body in the hole
/// gets through without touching, unless it was displaced to the same 12 digits.
struct Container {
  /// Counterclockwise, the first vertex on its hull. Its cavity has all vertices of the hole, and the mouth twice.
  SharedPolygon polygon;

  /// The vertex of the hole, and the edge from it, that a vertex of the polygon and the edge from it are; nothing for
  /// the box and the walls of the slit. Numbers are those of the hole's vertices as they were given.
  std::optional<std::uint32_t> vertex(std::uint32_t k) const;
  std::optional<std::uint32_t> edge(std::uint32_t k) const;

  std::uint32_t hole_size = 0;
  std::uint32_t mouth = 0;  ///< of the hole's vertices, the one at which it is cut open
  std::uint32_t first = 0;  ///< of the polygon's vertices, the mouth's first
};

/// Around a displaced hole, given clockwise: the material is to the left. Nothing where every vertex that could be the
/// mouth is so sharp that doubles leave no room for one.
std::optional<Container> container_around(std::span<const DisplacedPoint> hole);

}  // namespace taut::internal
