// Joints, drives and couplings of a mechanism from JSON.
#pragma once

#include "io/json_document.hpp"
#include "taut/envelope.hpp"

namespace taut::internal::io {

/// Drives from one value to another take the time from start to end.
Mechanism read_mechanism(const JsonDocument& document, std::size_t token, double start, double end);
/// Of a scene with joints instead of a time: each driven joint has a range, and is added to these.
Mechanism read_mechanism_with_ranges(const JsonDocument& document, std::size_t token, std::vector<Joint>& joints);

}  // namespace taut::internal::io
