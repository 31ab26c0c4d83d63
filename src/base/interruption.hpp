// Long computations can be told to stop: by a flag, by the clock, or after some effort.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace taut {

/// Thrown by interruption_point() where the present scope asks for it.
struct Interrupted {
  const char* reason;
};

/// While it lives, interruption points of this thread look at the flag and at the clock, and at those of the scopes
/// around it.
class InterruptionScope {
 public:
  using Clock = std::chrono::steady_clock;

  /// `stop` may be null. The limit counts from now, in seconds.
  InterruptionScope(const std::atomic<bool>* stop, double max_seconds);
  /// For about so many interruption points from now: the same number every time.
  explicit InterruptionScope(std::uint64_t effort);
  ~InterruptionScope();
  InterruptionScope(const InterruptionScope&) = delete;
  InterruptionScope& operator=(const InterruptionScope&) = delete;

  /// Throws Interrupted if it is time to stop.
  void check() const;
  /// Was the effort used up?
  bool exhausted() const { return exhausted_; }

 private:
  friend void interruption_point();
  void count();

  const std::atomic<bool>* stop_ = nullptr;
  bool limited_ = false;
  std::uint64_t effort_ = UINT64_MAX;
  bool exhausted_ = false;
  Clock::time_point deadline_{};
  InterruptionScope* outer_;
};

/// Looks at every 64th call.
void interruption_point();

}  // namespace taut
