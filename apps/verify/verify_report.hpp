// What `taut verify` and `taut-verify` do.
#pragma once

#include <string>

#include "taut/scene.hpp"

namespace taut::cli {

/// Checks the log and prints what it proves. Returns 0 if it is valid, 1 if not; throws InputError.
int verify_and_report(const Scene& scene, const std::string& scene_name, const std::string& log, bool json);

}  // namespace taut::cli
