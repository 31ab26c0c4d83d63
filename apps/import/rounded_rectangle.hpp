// Rectangles whose corners are quarters of ellipses; slots are such, too.
#pragma once

#include <string>

#include "import/affine.hpp"
#include "import/curves.hpp"

namespace taut::drawing {

/// From `low` to `high`, with radii that are at most half of the sides; 0 for sharp corners.
Chain rounded_rectangle(const Point& low, const Point& high, double rx, double ry, const Affine& where,
                        const std::string& place, Flattener& flattener);

}  // namespace taut::drawing
