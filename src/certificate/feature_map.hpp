// Translates the results of an engine to the user's terms: input indices, input units, world coordinates.
#pragma once

#include <functional>
#include <optional>

#include "certificate/contact_bracket.hpp"
#include "geometry/vector.hpp"
#include "numeric/errors.hpp"
#include "scene/body_pair.hpp"
#include "scene/overlap_witness.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// How two bodies overlap: two of their edges cross, or an outline of one lies inside the other.
struct StartOverlap {
  bool crossing = false;
  VertexId edge_p, edge_q;  ///< given by their first vertices, if they cross
  VertexId inside;          ///< otherwise, a vertex of that outline
};

/// Translates internal vertices and edges of one pair to the terms of the scene. The geometry is displaced as `offset`
/// says. It and the plan must outlive this object.
class FeatureMap {
 public:
  FeatureMap(const BodyPair& bodies, const PairGeometry& geometry, Offset offset)
      : bodies_(bodies), geometry_(geometry), offset_(offset) {}

  const BodyPair& bodies() const { return bodies_; }
  Offset offset() const { return offset_; }
  VertexRef vertex(VertexId v) const;
  /// The edge from v to the next vertex, counterclockwise.
  EdgeRef edge(VertexId v) const;
  /// The position of a vertex at a parameter of a segment, in the frame of the segments and in internal units
  /// (rounded). Distances and directions are the world's up to a rotation.
  Vector in_frame(VertexId v, const MotionSegment& segment, double parameter) const;
  /// A point of that frame in world coordinates, in the input's units (rounded).
  Point world(Vector v, const MotionSegment& segment, double parameter) const;
  Point world(VertexId v, const MotionSegment& segment, double parameter) const {
    return world(in_frame(v, segment, parameter), segment, parameter);
  }
  /// The contact found by an engine on that segment, stated so that it holds for the given bodies: see
  /// contact_bracket().
  Contact contact(const FoundContact& found, const MotionSegment& segment, Passage passage = Passage::enters) const;
  /// The contact at time t of two bodies that touch there, given how their outward shapes overlap. Of two edges that
  /// cross, the vertex is the endpoint of one that is nearest to the other edge. For a vertex inside, the edge is the
  /// nearest one: such a body fits into a hole so closely that all of it touches.
  Contact contact_of_overlap(const StartOverlap& overlap, const MotionSegment& segment, double t) const;

 private:
  VertexId nearest_edge(VertexId v, const MotionSegment& segment, double t) const;
  Contact contact_at(VertexId vertex, VertexId edge, const MotionSegment& segment, double lo, double hi) const;
  double distance(VertexId v, VertexId edge, const MotionSegment& segment, double t) const;
  Point outward_normal(VertexId edge, const MotionSegment& segment, double parameter) const;

  const BodyPair& bodies_;
  const PairGeometry& geometry_;
  Offset offset_;
};

// Contact at the start, before any motion.
//
// Shapes displaced inwards, for open touching, overlap only where the bodies do. Shapes displaced outwards, for closed
// touching, also overlap where the bodies merely touch; in that case the inward shapes do not overlap. Each engine
// determines in its own way whether and how shapes overlap. This file interprets the result for all of them.
//
// Other queries make no such distinction. Bodies that touch block a placement of a robot and violate a clearance just
// as overlapping bodies do. Polygons around curves overlap where the curves touch, or come near.

struct StartContact {
  StartOverlap how;  ///< of the outward shapes
  Contact contact;
};

/// How the outlines overlap at t. If none of their edges cross, the result is a vertex that is known to be inside.
inline StartOverlap overlap_of_outlines(const PairGeometry& geometry, const MotionSegment& segment, double t,
                                        const std::optional<VertexId>& inside = {}) {
  if (const auto crossing = crossing_edges(Placement(geometry, segment, t)))
    return {true, crossing->p, crossing->q, {}};
  if (!inside) throw StructureError("bodies that touch without a crossing of their outlines");
  return {false, {}, {}, *inside};
}

/// For displaced shapes that overlap at t: the contact of their bodies, or nothing if the bodies overlap, too. `how()`
/// returns how the shapes overlap. `overlap(geometry)` returns whether shapes with another displacement overlap.
template <class How, class Overlap>
std::optional<StartContact> contact_at_start(const FeatureMap& witness, const MotionSegment& segment, double t,
                                             const How& how, const Overlap& overlap) {
  if (witness.offset() == Offset::inward || overlap(displaced_pair(witness.bodies(), Offset::inward)))
    return std::nullopt;
  const StartOverlap found = how();
  return StartContact{found, witness.contact_of_overlap(found, segment, t)};
}

}  // namespace taut::internal
