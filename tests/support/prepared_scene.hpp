// Scenes whose shapes were prepared beforehand.
#pragma once

#include "taut/scene.hpp"
#include "taut/shape.hpp"

namespace taut::testing {

/// Bodies of one polygon have it as a prepared shape, too; those of several parts stay as they are.
inline Scene prepared(Scene scene) {
  for (Body& body : scene.bodies) {
    if (body.parts.empty()) body.prepared = prepare(body.polygon, body.name);
  }
  return scene;
}

/// With nothing but the prepared shapes.
inline Scene without_polygons(Scene scene) {
  for (Body& body : scene.bodies) {
    if (body.prepared) body.polygon.clear();
  }
  return scene;
}

}  // namespace taut::testing
