// Work that leaves Python its interpreter, and can be stopped.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <optional>
#include <utility>

#include "numeric/budget.hpp"

namespace taut_python {

/// How often a thread looks for signals while it works.
constexpr std::chrono::milliseconds signal_period{50};

/// Looks for signals between two steps of the work, and tells it to stop where a handler raises an exception.
class SignalWatch {
 public:
  explicit SignalWatch(std::atomic<bool>& stop) : stop_(stop) {}

  /// Called without the interpreter's lock.
  void look();
  /// What a handler has raised; null if nothing. Handed over with the interpreter's lock.
  const std::exception_ptr& raised() const { return raised_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<bool>& stop_;
  Clock::time_point next_ = Clock::now() + signal_period;
  bool over_ = false;
  std::exception_ptr raised_;
};

/// For a thread that waits for others within attended(): looks for signals, as it does while it works.
void look_for_signals();

/// Does this thread run a handler of signals, in the middle of work?
bool handles_signals();

/// Runs `work` on this thread, whose checkpoints look for signals meanwhile. Called with the interpreter's lock.
void run_watched(std::atomic<bool>& stop, const std::function<void()>& work);

/// Runs `work`, and hands over what it returns or throws. Called with the interpreter's lock, which is free meanwhile:
/// other threads of Python go on. Where a handler of signals raises an exception, as for Ctrl-C, `stop` tells the work
/// to stop, and the exception goes on as soon as it has.
template <class Result>
Result attended(std::atomic<bool>& stop, const std::function<Result()>& work) {
  std::optional<Result> result;
  run_watched(stop, [&] { result.emplace(work()); });
  return std::move(*result);
}

/// The same with a flag of its own, which the work is given.
template <class Result>
Result attended(const std::function<Result(const std::atomic<bool>&)>& work) {
  std::atomic<bool> stop{false};
  return attended<Result>(stop, [&] { return work(stop); });
}

}  // namespace taut_python
