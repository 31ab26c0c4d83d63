// Which rings of two bodies can meet at all?
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/body_pair.hpp"

namespace taut::internal {

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
