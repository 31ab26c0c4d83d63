// Contact at the start, where nothing has moved yet.
//
// Shapes displaced inwards, for open touching, overlap only where the bodies do. Those displaced outwards, for closed
// touching, also overlap where bodies touch, and no more: then the inward shapes are apart. Whether shapes overlap, and
// how, every engine finds out in its own way; what it means is said here, for all of them.
//
// Others make no such difference. A placement of a robot is blocked, and a clearance not kept, by bodies that touch as
// by bodies that overlap; and polygons around curves overlap where the curves touch, or come near.
#pragma once

#include <optional>

#include "base/errors.hpp"
#include "pair/crossing_edges.hpp"
#include "sign/feature_map.hpp"

namespace taut::internal {

struct StartContact {
  StartOverlap how;  ///< of the outward shapes
  Contact contact;
};

/// How the outlines overlap at t: where none of their edges cross, by a vertex that is known to be inside.
inline StartOverlap overlap_of_outlines(const PairGeometry& geometry, const MotionSegment& segment, double t,
                                        const std::optional<VertexId>& inside = {}) {
  if (const auto crossing = crossing_edges(Placement(geometry, segment, t)))
    return {true, crossing->p, crossing->q, {}};
  if (!inside) throw StructureError("bodies that touch without a crossing of their outlines");
  return {false, {}, {}, *inside};
}

/// Of displaced shapes that overlap at t, `how()` tells how: the contact of their bodies, or nothing if these overlap,
/// too. `overlap(geometry)` tells whether shapes that are displaced otherwise do.
template <class How, class Overlap>
std::optional<StartContact> contact_at_start(const FeatureMap& witness, const MotionSegment& segment, double t,
                                             const How& how, const Overlap& overlap) {
  if (witness.inwards() || overlap(displaced_pair(witness.plan(), true))) return std::nullopt;
  const StartOverlap found = how();
  return StartContact{found, witness.contact_of_overlap(found, segment, t)};
}

}  // namespace taut::internal
