// What every scene must fulfil, two bodies or many.
#pragma once

#include "geometry/shape_facts.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Throws InputError unless the time interval is one.
void validate_time(const Scene& scene);

/// Exact predicates multiply coordinates of several bodies: throws InputError where their magnitudes are too far apart.
void validate_range(const ShapeFacts& a, const ShapeFacts& b);

}  // namespace taut::internal
