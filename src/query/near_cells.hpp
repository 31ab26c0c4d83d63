// Determines the cells of two bodies' curves that matter at an instant.
#pragma once

#include "scene/curved_world.hpp"

namespace taut::internal {

/// Marks the cells of both bodies whose distance from the other body at time t is at most their thickness plus `reach`.
/// Of two cells that differ much, only the thicker one is marked. The marks are estimates in doubles: they determine
/// where to refine, and prove nothing. Returns the number of marked cells that can be refined.
std::size_t mark_near(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, double reach,
                      CurvedWorld::Halvings& marks);

/// Do the curves of two bodies run along each other at that time, so closely that more than `most` cells would be
/// needed to separate them? This is an estimate in doubles, from the majority of the near cells. It serves only to stop
/// early.
bool run_along(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, std::uint64_t most);

}  // namespace taut::internal
