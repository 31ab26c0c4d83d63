// The path data of SVG.
#pragma once

#include <vector>

#include "import/affine.hpp"
#include "import/curves.hpp"
#include "import/xml_reader.hpp"

namespace taut::drawing {

/// The subpaths of the attribute `d`, placed by `where`, curves as chords. Throws InputError where the data cannot be
/// read: browsers draw what comes before, which is half of a part.
std::vector<Chain> read_path(const XmlElement& element, const Affine& where, Flattener& flattener);

}  // namespace taut::drawing
