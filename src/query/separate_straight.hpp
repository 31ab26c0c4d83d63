// The directions in which bodies come apart if they are moved straight.
#pragma once

#include "taut/separate.hpp"

namespace taut::internal {

/// separate() without turns.
Separation separate_straight(const Scene& scene, const SeparateOptions& options);

/// The removal of a body along its widest arc; it must have one.
RemovalStep widest_removal(const BodyDirections& can);

}  // namespace taut::internal
