// Ctrl-C ends a run with an answer.
#pragma once

#include <atomic>

namespace taut::cli {

/// From now on the first SIGINT or SIGTERM sets the flag that is returned; the second one ends the process as usual.
const std::atomic<bool>* stop_on_signals();

}  // namespace taut::cli
