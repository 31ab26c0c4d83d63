// Which cells of two bodies' curves matter at an instant?
#pragma once

#include "pair/curved_world.hpp"

namespace taut::internal {

/// Marks the cells of both bodies that are no farther from the other body at time t than they are thick, and than
/// `reach`; of two cells that differ much, the thicker one. What is marked is guessed in doubles: it says where to
/// refine, and nothing of what is true. Gives back how many there are that can become finer.
std::size_t mark_near(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, double reach,
                      CurvedWorld::Halvings& marks);

/// Do the curves of two bodies run along each other at that time, so closely that more than `most` cells would be
/// needed to tell them apart? Guessed in doubles, by what most of the near cells say: good for nothing but giving up
/// early.
bool run_along(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, std::uint64_t most);

}  // namespace taut::internal
