// Boards of KiCad: the edge of the board and the courtyards of its parts.
#pragma once

#include <string>

#include "import/drawing.hpp"

namespace taut::drawing {

/// Reads a .kicad_pcb file, of KiCad 5 on. The layers are "board", which is Edge.Cuts, and "courtyards F" and
/// "courtyards B", the two sides. Millimetres; y goes up. Throws InputError.
Drawing read_kicad(const std::string& text, const std::string& file, const ImportSettings& settings);

}  // namespace taut::drawing
