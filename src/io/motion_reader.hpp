// The "motion" of a body.
#pragma once

#include <string>

#include "io/json_document.hpp"
#include "taut/motion.hpp"

namespace taut::io {

/// null, an object, or an array of at most `max_pieces` objects with ascending "until".
Motion read_motion(const JsonDocument& document, std::size_t token, const std::string& path, std::size_t max_pieces);

}  // namespace taut::io
