#include "each_row.hpp"

#include <algorithm>
#include <exception>
#include <future>
#include <mutex>
#include <string>
#include <system_error>
#include <vector>

#include "attended.hpp"
#include "taut/error.hpp"

namespace taut_python {
namespace {

/// Rows that are taken at once: few enough for threads to end together, and enough for them not to meet.
constexpr std::size_t chunk = 8;

/// The work that threads share.
class SharedRows {
 public:
  SharedRows(std::size_t rows, const std::atomic<bool>& stop, const std::function<RowWork()>& worker)
      : rows_(rows), stop_(stop), worker_(worker), failed_(rows) {}

  /// Takes rows until there are none. Rows are handed out in order, so that all before one that fails are done.
  void work() {
    RowWork done;
    while (true) {
      const std::size_t begin = next_.fetch_add(chunk);
      const std::size_t end = std::min(begin + chunk, rows_);
      for (std::size_t row = begin; row < end; ++row) {
        if (row > failed_ || stop_.load(std::memory_order_relaxed)) return;
        try {
          if (!done) done = worker_();
          done(row);
        } catch (...) {
          fail(row);
          return;
        }
      }
      if (end >= rows_) return;
    }
  }

  void rethrow() const {
    if (!error_) return;
    const std::string row = "row " + std::to_string(failed_);
    try {
      std::rethrow_exception(error_);
    } catch (const taut::InputError& error) {
      throw error.within(row);
    } catch (const taut::UndecidedError& error) {
      throw taut::UndecidedError(row + ": " + error.what());
    } catch (const taut::InternalError& error) {
      throw taut::InternalError(row + ": " + error.what());
    }
  }

 private:
  void fail(std::size_t row) {
    const std::lock_guard lock(mutex_);
    if (row >= failed_) return;
    failed_ = row;
    error_ = std::current_exception();
  }

  const std::size_t rows_;
  const std::atomic<bool>& stop_;
  const std::function<RowWork()>& worker_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> failed_;
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

void each_row(std::size_t rows, std::size_t threads, const std::atomic<bool>& stop,
              const std::function<RowWork()>& worker) {
  SharedRows shared(rows, stop, worker);
  const std::size_t useful = std::min(threads, (rows + chunk - 1) / chunk);
  std::vector<std::future<void>> others;
  try {
    while (others.size() + 1 < useful) others.push_back(std::async(std::launch::async, [&shared] { shared.work(); }));
  } catch (const std::system_error&) {
    // As many as the system gives.
  }
  shared.work();
  for (std::future<void>& other : others) {
    while (other.wait_for(signal_period) != std::future_status::ready) look_for_signals();
  }
  shared.rethrow();
}

}  // namespace taut_python
