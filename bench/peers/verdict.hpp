// What an answer from sampled poses is worth, held against the certified one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "taut/check.hpp"

namespace taut::bench {

enum class Verdict {
  right,        ///< free and free, or the hit is seen at the first sample that is not before the contact
  early,        ///< a hit is reported while the bodies are still apart
  late,         ///< the hit is seen, but not at the first sample that is not before the contact
  missed,       ///< a contact in truth, reported free
  false_alarm,  ///< free in truth, reported a hit
};

/// "right", "early", "late", "missed" or "false alarm".
const char* to_string(Verdict verdict);

/// `contact` is an interval that certainly contains the first contact, none if the motion is free. `hit` is the number
/// of the first sample, out of those at the increasing `times`, at which an overlap was reported.
Verdict verdict_of_samples(const std::optional<TimeInterval>& contact, const std::vector<double>& times,
                           const std::optional<std::size_t>& hit);

/// The same for a continuous test that reports a time: right if it differs from the contact by at most `slack`.
Verdict verdict_of_time(const std::optional<TimeInterval>& contact, const std::optional<double>& hit, double slack);

}  // namespace taut::bench
