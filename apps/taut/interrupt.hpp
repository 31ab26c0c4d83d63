// Ctrl-C ends a run with an answer; no signal leaves half a file behind.
#pragma once

#include <atomic>

namespace taut::cli {

/// From now on signals that end the process remove what it has begun to write first.
void clean_up_on_signals();

/// From now on the first SIGINT or SIGTERM sets the flag that is returned; the second one ends the process as usual.
const std::atomic<bool>* stop_on_signals();

}  // namespace taut::cli
