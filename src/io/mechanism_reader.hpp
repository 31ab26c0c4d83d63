// Joints, drives and couplings of a mechanism from JSON.
#pragma once

#include "io/json_document.hpp"
#include "taut/mechanism.hpp"

namespace taut::internal::io {

/// Drives from one value to another take the time from start to end.
Mechanism read_mechanism(const JsonDocument& document, std::size_t token, double start, double end);

}  // namespace taut::internal::io
