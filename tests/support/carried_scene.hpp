// One motion, shared between a body and its parent.
#pragma once

#include "taut/scene.hpp"

namespace taut::testing {

/// The same two polygons, the second one carried by a parent: that goes the terms of odd degree of its way, and is
/// turned by 90 degrees if `turned`; the body goes the rest, and turns. Nothing is rounded, so that everything is where
/// it was. Not for bodies on orbits.
Scene carried(const Scene& scene, bool turned);

}  // namespace taut::testing
