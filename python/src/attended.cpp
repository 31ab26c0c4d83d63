#include "attended.hpp"

#include <future>
#include <utility>

namespace py = pybind11;

namespace taut_python {
namespace {

thread_local bool working = false, handling = false;

/// Handlers of signals run on the main thread only: others need not take the interpreter's lock to look.
bool is_main_thread() {
  const py::object main = py::module_::import("threading").attr("main_thread")();
  return main.attr("ident").cast<unsigned long>() == PyThread_get_thread_ident();
}

/// What the work throws; null if it throws nothing.
std::exception_ptr error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

/// Without the interpreter's lock.
std::exception_ptr run_here(SignalWatch& signals, const std::function<void()>& work) {
  const std::function<void()> look = [&signals] { signals.look(); };
  const taut::internal::Budget watched(look);
  working = true;
  const std::exception_ptr error = error_of(work);
  working = false;
  return error;
}

/// On a thread of its own.
std::exception_ptr run_aside(SignalWatch& signals, const std::function<void()>& work) {
  std::future<std::exception_ptr> error = std::async(std::launch::async, [&] { return error_of(work); });
  while (error.wait_for(signal_period) != std::future_status::ready) signals.look();
  return error.get();
}

}  // namespace

void SignalWatch::look() {
  if (over_ || Clock::now() < next_) return;
  const py::gil_scoped_acquire acquired;
  const bool before = std::exchange(handling, true);
  // Taken out of the interpreter at once: callbacks may follow before the work stops.
  if (PyErr_CheckSignals() != 0) raised_ = std::make_exception_ptr(py::error_already_set());
  handling = before;
  over_ = raised_ || !is_main_thread();
  if (raised_) stop_ = true;
  next_ = Clock::now() + signal_period;
}

void look_for_signals() {
  try {
    taut::internal::Budget(taut::Limits{}).check();
  } catch (const taut::internal::Interrupted&) {
    // Those who are waited for see the same limits.
  }
}

bool handles_signals() { return handling; }

void run_watched(std::atomic<bool>& stop, const std::function<void()>& work) {
  SignalWatch signals(stop);
  std::exception_ptr error;
  {
    const py::gil_scoped_release released;
    // A handler of signals or a callback may ask a question in the middle of another one: what this thread keeps for
    // that one, limits among it, is none of the new one's.
    error = working ? run_aside(signals, work) : run_here(signals, work);
  }
  if (signals.raised()) std::rethrow_exception(signals.raised());
  if (error) std::rethrow_exception(error);
}

}  // namespace taut_python
