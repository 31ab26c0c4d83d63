// A moving picture of a scene.
#pragma once

#include <string>

#include "taut/io.hpp"

namespace taut::cli {

/// From the start to the first contact, or to the end, as SVG; with fewer frames where the file would get large. The
/// bodies must not overlap at the start.
std::string animation(const Scene& scene, Touch touch, AnimateOptions options);

}  // namespace taut::cli
