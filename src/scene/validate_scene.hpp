// Is this input a scene that can be decided?
#pragma once

#include <string>

#include "geometry/prepared_shape.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Throws InputError unless the bodies' names differ, every ring is valid and lies as it must, parents and ignored
/// bodies exist, chains of parents end, and time and motions are as validate() requires. Refuses curves.
void validate_polygons(const Scene& scene);

/// Throws InputError unless the bodies' names differ and ignored bodies exist.
void validate_ignored(const Scene& scene);

/// Is the scene one pair of simple polygons in the world's frame: two bodies without parts, which are tested?
bool is_ring_pair(const Scene& scene);
/// Throws InputError unless it is. `use` says what requires it, as in "a trace".
void require_ring_pair(const Scene& scene, const std::string& use);

/// Throws InputError unless the time interval is one.
void validate_time(const Scene& scene);
/// Exact predicates multiply coordinates of several bodies: throws InputError where their magnitudes are too far apart.
void validate_range(const ShapeFacts& a, const ShapeFacts& b);

}  // namespace taut::internal
