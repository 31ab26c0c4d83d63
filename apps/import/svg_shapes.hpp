// The basic shapes of SVG.
#pragma once

#include <string>
#include <vector>

#include "import/affine.hpp"
#include "import/curves.hpp"
#include "import/svg_values.hpp"

namespace taut::drawing {

/// Is a length in percent of a viewport whose size is not known?
bool has_unknown_size(const XmlElement& shape, const Viewport& viewport);

/// The lines of a shape, as `where` places it; empty if it has no extent. Throws InputError.
std::vector<Chain> svg_shape(const XmlElement& shape, const Viewport& viewport, const Affine& where,
                             Flattener& flattener);

}  // namespace taut::drawing
