// Worlds of a few bodies with a few vertices, of which a soak sees many.
#pragma once

#include "support/large_world.hpp"
#include "support/layered.hpp"

namespace taut::testing {

/// World `number`, of 2 to 8 bodies, mostly 2 to 4; the same everywhere.
///
/// The families of large worlds, and two more. rooms: a body with a hole, often with pillars in it as parts, that now
/// and then moves; the others are in the hole, and may be carried by it. tied: two bodies, and the same two mirrored,
/// turned by a quarter, doubled in size, or moved on, so that several pairs meet at one instant, or nearly.
LargeWorld small_world(std::uint64_t number);

/// What the soak looks at: one world in 64 is large, and in one of three bodies and parts have layers.
inline LargeWorld soak_world(std::uint64_t number) {
  LargeWorld made = number % 64 == 0 ? large_world(number) : small_world(number);
  if (number % 3 != 0) return made;
  return {on_layers(std::move(made.world), number), made.family + " on layers"};
}

}  // namespace taut::testing
