// Long computations can be told to stop: by a flag, by the clock, or after some work.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "taut/limits.hpp"

namespace taut::internal {

/// Thrown by checkpoint() where the present scope asks for it.
struct Interrupted {
  const char* reason;
};

/// While it lives, interruption points of this thread look at the flag and at the clock, and at those of the scopes
/// around it.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  /// The seconds count from now.
  explicit Budget(const Limits& limits);
  /// For about so much work from now: the same every time. What has begun by then may go on for as much as `overtime`.
  explicit Budget(std::uint64_t effort, std::uint64_t overtime = 0);
  ~Budget();
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Throws Interrupted if it is time to stop.
  void check() const;
  /// Was the effort used up?
  bool exhausted() const { return exhausted_; }
  /// How much what comes next takes, if it was not begun because less was left.
  std::uint64_t wanted() const { return wanted_; }
  /// How much of what was stopped is not lost.
  std::uint64_t kept() const { return kept_; }

 private:
  friend void checkpoint(std::uint64_t);
  friend void checkpoint_before(std::uint64_t);
  friend void count_kept_work(std::uint64_t);
  void look();
  void look_ahead(std::uint64_t work);

  const std::atomic<bool>* stop_ = nullptr;
  bool limited_ = false;
  std::uint64_t end_ = UINT64_MAX, until_ = UINT64_MAX;  ///< which work_spent(), without overtime and with it
  bool exhausted_ = false;
  std::uint64_t wanted_ = 0, kept_ = 0;
  Clock::time_point deadline_{};
  Budget* outer_;
};

/// While it lives, this thread counts no work: what is made once and kept is made by whoever needs it first, who must
/// not seem slower for it than those who come later. Flags and clocks of the scopes around it are looked at as ever.
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

/// Counts so much work, and stops it where that is asked for. A unit is what a look at two boxes costs, some 50 ns of
/// 2020: whatever costs far more than that says how much. So the work of different engines can be compared, and is the
/// same on every machine.
void checkpoint(std::uint64_t work = 1);
/// Before something that has to be begun anew if it is stopped, and takes about so much: stops now where less is left.
void checkpoint_before(std::uint64_t work);
/// Of what is stopped now, so much is gone on with when it is begun again.
void count_kept_work(std::uint64_t work);
/// Counts it alone, where nothing may be left half done.
void count_work(std::uint64_t work);
/// All that this thread has counted so far.
std::uint64_t work_spent();

}  // namespace taut::internal
