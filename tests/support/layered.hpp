// Scenes whose bodies and parts have layers.
#pragma once

#include "support/made_world.hpp"
#include "support/rng.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

/// Few heights, so that layers often share ends, and now and then all layers.
inline Layers some_layers(Rng& rng) {
  if (rng.chance(0.15)) return {};
  const double lo = rng.between(0, 3);
  return {lo, lo + rng.between(1, 2)};
}

/// Parts of any kind get layers of their own, or those of their body.
template <class AnyPart>
void put_on_layers(Rng& rng, std::vector<AnyPart>& parts) {
  for (AnyPart& part : parts) {
    if (rng.chance(0.7)) part.z = some_layers(rng);
  }
}

/// The same scene with layers of bodies, of some parts, and of some bodies of one polygon as a part.
inline Scene on_layers(Scene scene, std::uint64_t seed) {
  Rng rng(seed);
  for (Body& body : scene.bodies) {
    if (rng.chance(0.8)) body.z = some_layers(rng);
    put_on_layers(rng, body.parts);
    put_on_layers(rng, body.curves);
  }
  return scene;
}

inline MadeWorld on_layers(MadeWorld world, std::uint64_t seed) {
  Rng rng(seed);
  for (MadeBody& body : world.bodies) {
    if (rng.chance(0.8)) body.z = some_layers(rng);
    put_on_layers(rng, body.parts);
  }
  return world;
}

}  // namespace taut::testing
