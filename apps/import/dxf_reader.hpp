// DXF drawings.
#pragma once

#include <string>

#include "import/drawing.hpp"

namespace taut::drawing {

/// The model space of an ASCII DXF. Each layer's lines are one sheet; blocks are put in where they are inserted, and
/// what they have on layer 0 goes to the layer of the insertion. Throws InputError.
Drawing read_dxf(const std::string& text, const std::string& file, const ImportSettings& settings);

}  // namespace taut::drawing
