// Layers of a drawing with heights across the plane.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/drawing.hpp"

namespace taut::drawing {

/// Adds one more layer to those that are read: "NAME", or "NAME=LO:HI", whose bodies reach from LO to HI. An end that
/// is left out is none: "NAME=3:" reaches from 3 up. Throws InputError, with `option` as its place, if LO is not
/// below HI.
void choose_layer(ImportSettings& settings, const std::string& choice, const char* option);

/// What a drawing has between the same two heights.
struct Level {
  std::optional<Layers> z;  ///< nothing: all heights
  Drawing drawing;          ///< with all layers of the whole, in order, but only some of their sheets
};

/// Takes the sheets out of the drawing. Levels are in the order of their first sheets; there is at least one.
std::vector<Level> take_levels(Drawing& drawing);

}  // namespace taut::drawing
