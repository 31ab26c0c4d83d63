// Worlds of a few bodies with a few vertices, of which a soak sees many.
#pragma once

#include "support/large_world.hpp"

namespace taut::testing {

/// World `number`, of 2 to 8 bodies, mostly 2 to 4; the same everywhere.
///
/// The families of large worlds, and two more. rooms: a body with a hole, often with pillars in it as parts, that now
/// and then moves; the others are in the hole, and may be carried by it. tied: two bodies, and the same two mirrored,
/// turned by a quarter, doubled in size, or moved on, so that several pairs meet at one instant, or nearly.
LargeWorld small_world(std::uint64_t number);

/// What the soak looks at: one world in 64 is large.
inline LargeWorld soak_world(std::uint64_t number) {
  return number % 64 == 0 ? large_world(number) : small_world(number);
}

}  // namespace taut::testing
