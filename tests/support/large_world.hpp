// Worlds for the soak: 2 to 60 bodies, with what makes worlds hard.
#pragma once

#include <cstdint>
#include <string>

#include "support/made_world.hpp"

namespace taut::testing {

struct LargeWorld {
  MadeWorld world;
  std::string family;  ///< cells, grid, mirrored, nested or arms; of small ones also rooms or tied
};

/// World `number`; the same everywhere.
///
/// cells: bodies in cells, some of several parts, with parents up to six deep. grid: whole numbers only, so that faces
/// slide on faces and several pairs meet at once; bodies of touching parts. mirrored: cells and their mirror image,
/// whose pairs meet at the same instants. nested: rings in rings, up to four deep. arms: chains of links that turn
/// about their joints among bodies at rest, neighbours ignored.
LargeWorld large_world(std::uint64_t number);

/// A world of so many bodies of one of these families, by number below `world_families`.
constexpr int world_families = 5;
LargeWorld world_of_family(int family, Rng& rng, int bodies);
/// Names for bodies that have none, and now and then some pairs that are not asked about.
void finish_world(Rng& rng, MadeWorld& world);

/// All but that body rest in the world's frame.
MadeWorld with_one_mover(MadeWorld world, int mover);

}  // namespace taut::testing
