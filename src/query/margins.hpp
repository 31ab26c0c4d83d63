// Whether bodies keep their margins.
#pragma once

#include "scene/pair_margins.hpp"
#include "taut/clearance.hpp"

namespace taut::internal {

/// check_clearance() with these margins, whatever clearances the scene has. Throws InputError.
MarginAnswer check_margins(const Scene& scene, const PairMargins& margins, const CheckOptions& options);

}  // namespace taut::internal
