// PNG images, by libpng.
#pragma once

#include <optional>
#include <string>

#include "taut/grid.hpp"

namespace taut::drawing {

/// The image in a PNG file, as map_server sees it: the mean of the colors; or nothing for other files. `file` is for
/// messages. Throws InputError if the file is damaged, or this program was built without libpng.
std::optional<GreyImage> read_png(const std::string& bytes, const std::string& file);

}  // namespace taut::drawing
