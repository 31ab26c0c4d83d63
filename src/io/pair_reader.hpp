// Pairs of bodies that a scene names: those that are not tested, and those with a clearance of their own.
#pragma once

#include "io/json_document.hpp"
#include "taut/scene.hpp"

namespace taut::internal::io {

/// The scene's "ignore".
std::vector<std::array<std::string, 2>> read_ignored(const JsonDocument& document, std::size_t token);
/// The scene's "clearances".
std::vector<PairClearance> read_clearances(const JsonDocument& document, std::size_t token);

}  // namespace taut::internal::io
