// What the user is told where the highest precision does not suffice.
#pragma once

#include <string>

#include "base/errors.hpp"

namespace taut {

/// The message for the user.
std::string not_decided(const Undecidable& limit);

}  // namespace taut
