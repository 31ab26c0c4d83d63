// SVG drawings.
#pragma once

#include <string>

#include "import/drawing.hpp"

namespace taut::drawing {

/// Shapes of an SVG document. What is outermost, a group or a shape by itself, is a layer, called by its label or id;
/// every filled shape is a sheet of its own, and lines that are not filled are one sheet together. y goes up, so that
/// the drawing is seen as it was. Throws InputError.
Drawing read_svg(const std::string& text, const std::string& file, const ImportSettings& settings);

}  // namespace taut::drawing
