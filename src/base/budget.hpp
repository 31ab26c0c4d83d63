// Long computations can be stopped: by a flag, by the clock, or after a given amount of work.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "taut/limits.hpp"

namespace taut::internal {

/// Thrown by checkpoint() if the current budget requires it.
struct Interrupted {
  const char* reason;
};

/// While it lives, the checkpoints of this thread test the flag and the clock, and those of the enclosing budgets.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  /// The seconds count from now.
  explicit Budget(const Limits& limits);
  /// A budget for about this much work from now on; deterministic. Work begun by then may continue for as much as
  /// `overtime`.
  explicit Budget(std::uint64_t effort, std::uint64_t overtime = 0);
  ~Budget();
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Throws Interrupted if it is time to stop.
  void check() const;
  /// Was the effort used up?
  bool exhausted() const { return exhausted_; }
  /// The work that the next operation needs, if it was not begun because less was left.
  std::uint64_t wanted() const { return wanted_; }
  /// The amount of interrupted work that is not lost.
  std::uint64_t kept() const { return kept_; }

 private:
  friend void checkpoint(std::uint64_t);
  friend void checkpoint_before(std::uint64_t);
  friend void count_kept_work(std::uint64_t);
  void look();
  void look_ahead(std::uint64_t work);

  const std::atomic<bool>* stop_ = nullptr;
  bool limited_ = false;
  std::uint64_t end_ = UINT64_MAX, until_ = UINT64_MAX;  ///< the values of work_spent() at the end, without overtime
                                                         ///< and with it
  bool exhausted_ = false;
  std::uint64_t wanted_ = 0, kept_ = 0;
  Clock::time_point deadline_{};
  Budget* outer_;
};

/// While it lives, this thread counts no work. Data that is computed once and cached is computed by the first caller
/// that needs it, and that caller must not appear slower than later ones. The flags and clocks of enclosing budgets are
/// still tested.
class UnmeteredScope {
 public:
  UnmeteredScope();
  ~UnmeteredScope();
  UnmeteredScope(const UnmeteredScope&) = delete;
  UnmeteredScope& operator=(const UnmeteredScope&) = delete;

 private:
  std::uint64_t spent_, next_look_;
  Budget unlimited_;
};

/// Counts this much work, and throws Interrupted if the budget requires it. A unit is the cost of testing two boxes,
/// some 50 ns in 2020. Operations that cost far more state their work. So the work of different engines can be
/// compared, and is the same on every machine.
void checkpoint(std::uint64_t work = 1);
/// Called before an operation of about this much work that would have to restart if interrupted. Throws now if less is
/// left.
void checkpoint_before(std::uint64_t work);
/// Records that this much of the work interrupted now will be resumed, not repeated.
void count_kept_work(std::uint64_t work);
/// Counts the work without a test, where nothing may be left half done.
void count_work(std::uint64_t work);
/// The total work that this thread has counted so far.
std::uint64_t work_spent();

}  // namespace taut::internal
