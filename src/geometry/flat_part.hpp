// Bands as fine as they are wanted everywhere.
#pragma once

#include <string>

#include "geometry/banded_part.hpp"

namespace taut::internal::curve {

/// Halves what is thicker than the tolerance. Throws InputError where doubles do not allow that.
void refine_to(BandedPart& part, double tolerance, const std::string& name);

}  // namespace taut::internal::curve
