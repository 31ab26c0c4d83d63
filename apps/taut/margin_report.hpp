// The answer to whether bodies keep a clearance, in words.
#pragma once

#include <string>

#include "taut/clearance.hpp"

namespace taut::cli {

/// A few lines for a person.
std::string margin_in_words(const Scene& scene, double clearance, const MarginAnswer& answer);

}  // namespace taut::cli
