// The boundaries of HATCH, MPOLYGON, SOLID and TRACE.
#pragma once

#include <vector>

#include "import/affine.hpp"
#include "import/curves.hpp"
#include "import/dxf_text.hpp"

namespace taut::drawing {

/// The closed boundaries of a filling, counterclockwise, but for room for texts. Throws InputError where they cannot be
/// read.
std::vector<Chain> hatch_boundaries(const DxfItem& item, const Affine& where, Flattener& flattener);

/// How the boundaries of a filling lie in each other: islands in islands are filled, or only what is next to the
/// outermost boundaries is, or all within them.
Fill fill_of_hatch(const DxfItem& item);

/// The boundary of a SOLID or TRACE, which has three or four corners.
Chain solid_boundary(const DxfItem& item, const Affine& where);

}  // namespace taut::drawing
