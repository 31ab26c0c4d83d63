// Bodies and their features in words.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

/// "vertex 3 of hole 1 of part 0 of lid".
std::string vertex_text(const Scene& scene, const VertexRef& vertex);
/// "edge 3-4 of lid".
std::string edge_text(const Scene& scene, const EdgeRef& edge);
/// The pair, or the two bodies that there are, or how many.
std::string subject_text(const Scene& scene, const std::optional<std::array<BodyId, 2>>& pair);

}  // namespace taut::cli
