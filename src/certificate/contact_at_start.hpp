// Contact at the start, before any motion.
//
// Shapes displaced inwards, for open touching, overlap only where the bodies do. Shapes displaced outwards, for closed
// touching, also overlap where the bodies merely touch; in that case the inward shapes do not overlap. Each engine
// determines in its own way whether and how shapes overlap. This file interprets the result for all of them.
//
// Other queries make no such distinction. Bodies that touch block a placement of a robot and violate a clearance just
// as overlapping bodies do. Polygons around curves overlap where the curves touch, or come near.
#pragma once

#include <optional>

#include "certificate/feature_map.hpp"
#include "numeric/errors.hpp"
#include "scene/crossing_edges.hpp"

namespace taut::internal {

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
