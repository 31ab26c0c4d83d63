// Long computations can be told to stop: by a flag, or by the clock.
#pragma once

#include <atomic>
#include <chrono>

namespace taut {

/// Thrown by interruption_point() where the present scope asks for it.
struct Interrupted {
  const char* reason;
};

/// While it lives, interruption points of this thread look at the flag and at the clock.
class InterruptionScope {
 public:
  using Clock = std::chrono::steady_clock;

  /// `stop` may be null. The limit counts from now, in seconds.
  InterruptionScope(const std::atomic<bool>* stop, double max_seconds);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

  /// Throws Interrupted if it is time to stop.
  void check() const;

 private:
  const std::atomic<bool>* stop_;
  bool limited_;
  Clock::time_point deadline_{};
  const InterruptionScope* outer_;
};

/// Looks at every 64th call.
void interruption_point();

}  // namespace taut
