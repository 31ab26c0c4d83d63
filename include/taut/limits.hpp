// When a question gives up.
#pragma once

#include <atomic>

namespace taut {

/// A part of the options of every question. What is not decided within these limits is reported as undecided, with the
/// reason; what is reported as decided does not depend on them.
struct Limits {
  /// Wall time in seconds; at 0, nothing is tested.
  double max_seconds = 1e300;
  /// Give up soon after this becomes true, for instance from a signal handler. May be null. Not owned.
  const std::atomic<bool>* stop = nullptr;
};

}  // namespace taut
