// Plans that change while the bodies move, as scenes whose motions have pieces.
#pragma once

#include <string>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::fuzz {

/// Runs the scene with each piece announced only when it begins: the plan is changed at every joint. The answer must be
/// that of the scene as a whole, `whole`, and the maps after each change must be the static ones. Says what is wrong,
/// or nothing. Throws as Session does, but nothing for limits that were hit.
std::string audit_plan_changes(const Scene& scene, const Answer& whole, const CheckOptions& options);

}  // namespace taut::fuzz
