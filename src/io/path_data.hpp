// The data of an SVG path.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/outline.hpp"

namespace taut::internal::io {

/// At least one segment; closed by Z, or open.
struct Subpath {
  Outline outline;
  bool closed = false;
};

/// Throws InputError, which names `place`, where the data cannot be read: browsers draw what comes before, which is
/// half of a part.
std::vector<Subpath> read_path_data(std::string_view data, const std::string& place);

}  // namespace taut::internal::io
