// A scene in the terms of the engines: which body is P, scaled coordinates, vertices in order.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/prepared_shape.hpp"
#include "pair/pair_geometry.hpp"
#include "pair/ring_set.hpp"
#include "relative/motion_segments.hpp"
#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Which body plays P or Q, and how its internal vertices are numbered in the input.
struct BodyMap {
  BodyId body = 0;
  std::uint32_t size = 0;   ///< number of vertices
  std::uint32_t first = 0;  ///< index of the input that became vertex 0
  bool reversed = false;    ///< the input runs clockwise

  int vertex(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + size - k) % size : (first + k) % size);
  }
  int edge(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + 2 * size - k - 1) % size : (first + k) % size);
  }
};

/// Everything about a scene that does not depend on the touch mode.
struct PairPlan {
  std::array<BodyMap, 2> maps;       ///< of P and of Q
  std::array<std::string, 2> names;  ///< of P and of Q
  /// Scaled, counterclockwise, first vertex on the hull.
  std::array<std::shared_ptr<const std::vector<Point>>, 2> polygons;
  std::array<PieceList, 2> pieces;                               ///< scaled
  std::array<Bounds, 2> bounds;                                  ///< in the input's units
  std::array<std::shared_ptr<const PreparedShape>, 2> prepared;  ///< if they are
  /// In a world: what P and Q are. Then the maps, the polygons and the pieces above are empty.
  std::array<std::shared_ptr<const RingSet>, 2> rings;
  /// In a world: the parents' motions that both chains begin with, the outermost first; scaled. Segments are seen from
  /// the last of them, since it decides nothing; what is reported is put back into the world by them (FeatureMap).
  MotionChain common;
  int exponent = 0;   ///< internal coordinates are the input's times 2^exponent
  double extent = 0;  ///< of the scene, in the input's units
};

/// As facts_of(body.polygon), which may be known already.
ShapeFacts facts_of(const Body& body);
/// The same scene with shapes that are prepared, for whoever asks about it more than once. Throws InputError where
/// validate() does because of its polygons.
Scene with_prepared_shapes(const Scene& scene);
/// Validates the scene (see validate()), and keeps what was found out about its polygons.
std::array<ShapeFacts, 2> validated_facts(const Scene& scene);

/// The scene must be valid.
PairPlan plan_pair(const Scene& scene, const std::array<ShapeFacts, 2>& facts);
inline PairPlan plan_pair(const Scene& scene) {
  return plan_pair(scene, {facts_of(scene.bodies[0]), facts_of(scene.bodies[1])});
}

/// What is kept of P or Q if it is a prepared shape; else null.
const ShapeInRole* shape_in_role(const PairPlan& plan, Role role, bool inwards);

/// The two polygons, displaced inwards or outwards. Throws InputError where one of them has features that are finer
/// than the displacement.
PairGeometry displaced_pair(const PairPlan& plan, bool inwards);
/// The same, or nothing.
std::optional<PairGeometry> displaced_pair_if_possible(const PairPlan& plan, bool inwards);

}  // namespace taut::internal
