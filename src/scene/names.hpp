// Names that are not there, and what was meant.
#pragma once

#include <string>
#include <vector>

#include "taut/error.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// The word of `known` that `word` is most likely a slip of; empty if none is near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

std::vector<std::string> names_of(const std::vector<Body>& bodies);

/// That no body is called so, and `what` it was named for. The body that may be meant comes before the hint.
InputError no_such_body(const std::vector<std::string>& known, const std::string& name, const std::string& place,
                        const std::string& what, const std::string& hint);

}  // namespace taut::internal
