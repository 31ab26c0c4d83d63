// Layers in words, for pictures and reports.
#pragma once

#include <string>

#include "taut/geometry.hpp"

namespace taut::internal::io {

/// "z 0..3", "z 3.." where there is no upper end, or "all layers".
std::string heights_text(const Layers& z);

}  // namespace taut::internal::io
