// Is this input a world that can be decided?
#pragma once

#include "taut/scene.hpp"

namespace taut::internal {

/// Is it more, or less, than two bodies of one polygon each that are seen from the world's frame?
bool is_world(const Scene& scene);

/// Throws InputError unless the polygon of a body without parts is valid. That of a prepared shape is; then the body
/// has no other.
void validate_polygon_of(const Body& body);

/// Throws InputError unless the bodies' names differ, every ring is valid and lies as it must, parents and ignored
/// bodies exist, chains of parents end, and time and motions are as validate() wants them.
void validate_world(const Scene& scene);

}  // namespace taut::internal
