// Small changes of scenes, most of which leave them valid.
#pragma once

#include "support/rng.hpp"
#include "taut/scene.hpp"

namespace taut::fuzz {

/// What a scene of fuzz_session may be: small, so that many are tried.
struct SceneSize {
  std::size_t vertices = 24;  ///< of one body
  std::size_t pieces = 4;     ///< of one body
  std::size_t degree = 6;
};

bool fits(const Scene& scene, const SceneSize& size);

/// Changes one thing, and drops what is too much for `size`.
Scene mutated(testing::Rng& rng, Scene scene, const SceneSize& size);

}  // namespace taut::fuzz
