// Random worlds of two bodies, one in a hole of the other that is closed on all sides.
#pragma once

#include <cstdint>

#include "support/random_scenes.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

enum class Cavity : std::uint8_t {
  island,  ///< one of a pair of polygons has grown a wall around both: what is left free winds around it
  rock,    ///< a star in a star
  ring,    ///< a cog in a ring with teeth inside, a tooth in each space, more or less
  cells,   ///< a body of two parts, each in a hole of its own, one of which has something in it
};

inline constexpr Cavity all_cavities[] = {Cavity::island, Cavity::rock, Cavity::ring, Cavity::cells};

const char* to_string(Cavity cavity);

struct CavityOptions {
  bool grid = false;     ///< as in SceneOptions, where the cavity is an island
  bool parents = false;  ///< what is inside is seen from another body, which is far away and moves
};

/// The scene of a seed; valid. Body 0 has the cavity, body 1 is in it, body 2 is the parent if there is one.
Scene cavity_scene(std::uint64_t seed, Cavity cavity, const CavityOptions& options = {});

}  // namespace taut::testing
