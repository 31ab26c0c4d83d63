#include "attended.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

thread_local bool working = false, handling = false;

/// Handlers of signals run on the main thread only: others need not take the interpreter's lock to look.
bool is_main_thread() {
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
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

}  // namespace

void SignalWatch::look() {
  if (over_ || Clock::now() < next_) return;
  const py::gil_scoped_acquire acquired;
  handling = true;
  raised_ = PyErr_CheckSignals() != 0;
  handling = false;
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
    if (working) {
      // A handler of signals or a callback asks a question, in the middle of another one: what that thread keeps for
      // its work, limits among it, is none of this work's.
      std::thread([&] { error = error_of(work); }).join();
    } else {
      error = run_here(signals, work);
    }
  }
  if (signals.raised()) throw py::error_already_set();
  if (error) std::rethrow_exception(error);
}

}  // namespace taut_python
