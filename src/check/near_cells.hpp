// Which cells of two bodies' curves matter at an instant?
#pragma once

#include "pair/curved_world.hpp"

namespace taut {

/// Marks the cells of both bodies that are no farther from the other body at time t than they are thick, and than
/// `reach`; of two cells that differ much, the thicker one. What is marked is guessed in doubles: it says where to
/// refine, and nothing of what is true. Gives back how many there are that can become finer.
std::size_t mark_near(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, double reach,
                      CurvedWorld::Halvings& marks);

}  // namespace taut
