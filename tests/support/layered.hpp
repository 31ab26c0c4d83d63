// Scenes whose bodies and parts have layers.
#pragma once

#include "support/rng.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

/// Few heights, so that layers often share ends, and now and then all layers.
inline Layers some_layers(Rng& rng) {
  if (rng.chance(0.15)) return {};
  const double lo = rng.between(0, 3);
  return {lo, lo + rng.between(1, 2)};
}

/// The same scene with layers of bodies, of some parts, and of some bodies of one polygon as a part.
inline Scene on_layers(Scene scene, std::uint64_t seed) {
  Rng rng(seed);
  for (Body& body : scene.bodies) {
    if (rng.chance(0.8)) body.z = some_layers(rng);
    for (Part& part : body.parts) {
      if (rng.chance(0.7)) part.z = some_layers(rng);
    }
    for (CurvedPart& part : body.curves) {
      if (rng.chance(0.7)) part.z = some_layers(rng);
    }
  }
  return scene;
}

}  // namespace taut::testing
