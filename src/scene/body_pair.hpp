// Two bodies in the terms of the engines: which one plays P, their displaced rings, their motions in one scale.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "geometry/displacement.hpp"
#include "geometry/ids.hpp"
#include "motion/motion_segments.hpp"
#include "scene/pair_geometry.hpp"
#include "scene/ring_set.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

using SharedRings = std::shared_ptr<const RingSet>;

/// The largest magnitude of a coordinate of the body's outlines.
double largest_coordinate(const Body& body);

/// Everything about a pair of bodies that does not depend on the touch mode. Lengths are the input's times 2^exponent.
struct BodyPair {
  std::array<SharedRings, 2> rings;  ///< of P and of Q
  /// Of P and of Q: the motions of their parents, the outermost first, and their own, without the common ones. One that
  /// rests if there are no others.
  std::array<MotionChain, 2> motions;
  /// The parents' motions that both chains begin with, or P's, where a joint shows how Q moves from there. Segments are
  /// seen from the last of them, since it decides nothing; what is reported is put back into the world by them
  /// (FeatureMap).
  MotionChain common;
  int exponent = 0;

  int body(Role role) const { return rings[index_of(role)]->body(); }
  /// Is each body one ring? Then one tiling is enough.
  bool has_single_rings() const { return rings[0]->rings().size() == 1 && rings[1]->rings().size() == 1; }
};

/// The pair in its roles: P is the body with the larger diameter, and the first one if they are equal (section 2.1 of
/// the paper). Both chains begin with the outermost parent.
BodyPair pair_of(const SharedRings& first, const MotionChain& first_motions, const SharedRings& second,
                 const MotionChain& second_motions);
/// A scene of two bodies without parents, which must be valid.
BodyPair pair_of(const Scene& scene);

/// The relative motion of P and Q, in a frame that parents which both have are not in.
MotionSegments segments_of(const BodyPair& pair, double start, double end);

/// The question about bodies is answered by bodies displaced to this side.
inline Offset offset_for(Touch touch) { return touch == Touch::open ? Offset::inward : Offset::outward; }

/// The two bodies, displaced. Throws InputError where one of them has features that are finer than
/// the displacement.
PairGeometry displaced_pair(const BodyPair& bodies, Offset offset);
/// The same, or nothing.
std::optional<PairGeometry> displaced_pair_if_possible(const BodyPair& bodies, Offset offset);

// Which rings of two bodies can meet at all?

class Placement;

/// A ring of P and one of Q, by their numbers in the bodies.
struct RingMeeting {
  std::size_t p, q;
};

struct RingMeetings {
  std::vector<RingMeeting> pairs;
  std::optional<VertexId> inside;  ///< a vertex of one body in the other one: they overlap, and there are no pairs
};

/// For each part of P and each part of Q, the two rings between which the free space of both lies: their outlines,
/// where neither part is within the other's; else the hole that the one is in, and the outline of the other. No other
/// rings of these parts can meet before these do. Crossings are not looked for: where outlines or holes cross, rings
/// that are named cross as well, or a vertex is inside.
///
/// The placement is that of the bodies of rings, displaced. Exact; throws Undecidable.
RingMeetings ring_meetings(const BodyPair& bodies, const Placement& placement);

}  // namespace taut::internal
