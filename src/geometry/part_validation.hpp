// Do the rings of a part lie as they must?
#pragma once

#include <string>

#include "taut/geometry.hpp"

namespace taut::internal {

/// Throws InputError unless the closed inside of every hole lies in the inside of the outline, and no two of them
/// touch. The rings must be valid polygons. Exact; about O(n log n) where few edges lie one above the other. `name` is
/// the body's, and part's, in messages; holes are counted from 1.
void validate_holes(const Part& part, const std::string& name);

}  // namespace taut::internal
