// Work that leaves Python its interpreter, and can be stopped.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace taut_python {

/// How often the calling thread looks for signals while work is done.
constexpr std::chrono::milliseconds signal_period{20};

/// Runs `work` on a thread of its own, and hands over what it returns or throws. Called with the interpreter's lock,
/// which is free meanwhile: other threads of Python go on. Where a handler of signals raises an exception, as for
/// Ctrl-C, `stop` tells the work to stop, and the exception goes on as soon as it has.
template <class Result>
Result attended(std::atomic<bool>& stop, const std::function<Result()>& work) {
  std::mutex mutex;
  std::condition_variable finished;
  bool done = false;
  std::optional<Result> result;
  std::exception_ptr error;
  std::thread worker([&] {
    try {
      result.emplace(work());
    } catch (...) {
      error = std::current_exception();
    }
    // Told under the lock: once it is free, the calling thread may be gone from here, and what is told with it.
    const std::lock_guard lock(mutex);
    done = true;
    finished.notify_one();
  });
  bool raised = false;
  {
    pybind11::gil_scoped_release released;
    std::unique_lock lock(mutex);
    while (!finished.wait_for(lock, signal_period, [&] { return done; })) {
      lock.unlock();
      {
        pybind11::gil_scoped_acquire acquired;
        raised = PyErr_CheckSignals() != 0;
      }
      lock.lock();
      if (raised) break;
    }
    lock.unlock();
    if (raised) stop = true;
    worker.join();
  }
  if (raised) throw pybind11::error_already_set();
  if (error) std::rethrow_exception(error);
  return std::move(*result);
}

/// The same with a flag of its own, which the work is given.
template <class Result>
Result attended(const std::function<Result(const std::atomic<bool>&)>& work) {
  std::atomic<bool> stop{false};
  return attended<Result>(stop, [&] { return work(stop); });
}

}  // namespace taut_python
