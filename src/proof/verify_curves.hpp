// Checks logs about scenes with curves.
#pragma once

#include "proof/header.hpp"
#include "taut/scene.hpp"

namespace taut::internal::proof {

/// A log is polygons around the bodies and a log about these, and then, for what they do, polygons within and a log
/// about those: docs/separation-logs.md. Throws ProofError, and InputError if the scene is not valid.
Verified verify_curves(const Scene& scene, std::istream& log);

}  // namespace taut::internal::proof
