// The same world told in other words: its answer must stay.
#pragma once

#include <optional>
#include <string>

#include "support/made_world.hpp"

namespace taut::testing {

/// Every body that is a star, with or without a hole, is cut from its middle or its hole outwards into two touching
/// pieces (of a ring: two letters C), every bar into two halves. How many were cut is added to `count`.
MadeWorld cut_at_seams(Rng& rng, const MadeWorld& world, int& count);
/// All that stands in the world's frame is put on a body that moves, about which nothing is asked.
MadeWorld carried_as_a_whole(Rng& rng, const MadeWorld& world);
/// Three bodies more, out of reach, of which two move.
MadeWorld with_far_bodies(std::uint64_t seed, const MadeWorld& world);
/// The bodies in another order; names stay.
MadeWorld in_another_order(Rng& rng, const MadeWorld& world);
/// Seen from a frame that goes straight ahead; nothing where a root moves otherwise than straight.
std::optional<MadeWorld> seen_from_a_moving_frame(Rng& rng, const MadeWorld& world);

}  // namespace taut::testing
