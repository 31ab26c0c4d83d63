// Is this input a scene that can be decided?
#pragma once

#include "taut/scene.hpp"

namespace taut {

/// Throws InputError unless the polygon has at least 3 vertices, all finite and distinct, and its boundary is simple.
/// Exactly collinear consecutive vertices are fine. O(n log n). `name` is used in messages.
void validate_polygon(const Polygon& polygon, const std::string& name);

/// Throws InputError for everything that check() would refuse: number of bodies (exactly two, at present), polygons,
/// time interval, motions and their joints.
void validate(const Scene& scene);

}  // namespace taut
