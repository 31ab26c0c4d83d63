// Long computations can be stopped: by a flag, by the clock, or after a given amount of work. They report their
// progress.
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>

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
  /// A budget for about this much work from now on; deterministic.
  explicit Budget(std::uint64_t effort);
  /// No limit of its own: its checkpoints call `look`, which must outlive it.
  explicit Budget(const std::function<void()>& look);
  ~Budget();
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  /// Throws Interrupted if it is time to stop.
  void check() const;

 private:
  friend void checkpoint(std::uint64_t);
  void test_limits();

  const std::atomic<bool>* stop_ = nullptr;
  const std::function<void()>* look_ = nullptr;
  bool limited_ = false;
  std::uint64_t end_ = UINT64_MAX;  ///< the value of work_spent() at the end
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
/// Counts the work without a test, where nothing may be left half done.
void count_work(std::uint64_t work);
/// The total work that this thread has counted so far.
std::uint64_t work_spent();

/// A share of the work for a method that can pause between two steps of its own, as two boxes that are compared, or an
/// event. Nothing ends in the middle of a step, so a slice may take longer by one step.
class Slice {
 public:
  explicit Slice(std::uint64_t effort = UINT64_MAX);
  bool used_up() const { return work_spent() >= end_; }

 private:
  std::uint64_t end_;
};

// The progress of a long query, for a user who waits for the answer.

/// Written by the working thread, and read by one that displays it.
struct ProgressMeter {
  void set(const char* parts, std::uint64_t number, std::uint64_t total);

  std::atomic<const char*> kind{nullptr};      ///< the kind of parts counted, such as "pairs"
  std::atomic<std::uint64_t> done{0}, all{0};  ///< the numbers of parts; `all` is 0 if not known
  std::atomic<double> share{-1};               ///< of the whole query, from 0 to 1; below 0 if not known
  std::atomic<double> seconds_left{-1};        ///< expected; below 0 if not known
  std::atomic<double> time{-INFINITY};         ///< searched up to this instant of the scene
};

/// While it lives, the reports of this thread go to the meter.
class ProgressScope {
 public:
  explicit ProgressScope(ProgressMeter& meter);
  ~ProgressScope();
  ProgressScope(const ProgressScope&) = delete;
  ProgressScope& operator=(const ProgressScope&) = delete;

 private:
  ProgressMeter* outer_;
};

/// Reports that `done` parts of a kind are done, of `all`, if that is known. Without a scope, this has no effect.
void report_parts(const char* kind, std::uint64_t done, std::uint64_t all = 0);
/// Reports that the scene has been searched up to t, which is not earlier than reported before.
void report_time(double t);
/// Reports the share of the query that is decided.
void report_share(double share);

}  // namespace taut::internal
