// Which rings of two bodies can meet at all?
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pair/pair_plan.hpp"

namespace taut {

class Placement;

/// A ring of P and one of Q, by their numbers in the bodies.
struct RingMeeting {
  std::size_t p, q;
};

/// For each part of P and each part of Q, the two rings between which the free space of both lies: their outlines,
/// where neither part is within the other's; else the hole that the one is in, and the outline of the other. No other
/// rings of these parts can meet before these do. Nothing where a vertex of one part's outline lies in the other one:
/// they overlap. Rings that cross are not looked for: then those that are named do, or others of two overlapping parts.
///
/// The placement is that of the bodies of rings, displaced. Exact; throws Undecidable.
std::optional<std::vector<RingMeeting>> ring_meetings(const PairPlan& plan, const Placement& placement);

}  // namespace taut
