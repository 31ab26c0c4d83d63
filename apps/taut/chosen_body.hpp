// The body that an option names.
#pragma once

#include <string>

#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

/// The body of that name; for an empty name the only one that moves, or the only one. Throws InputError, which names
/// the bodies there are.
BodyId chosen_body(const Scene& scene, const std::string& name);

}  // namespace taut::cli
