#include "check_rows.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace taut_python {
namespace {

/// Rows that are taken at once: few enough for threads to end together, and enough for them not to meet.
constexpr std::size_t chunk = 8;

/// The work that threads share.
class Rows {
 public:
  Rows(const RowScenes& scenes, const taut::CheckOptions& options, AnswerRow* answers)
      : scenes_(scenes), options_(options), answers_(answers), failed_(scenes.size()) {}

  /// Takes rows until there are none. Rows are handed out in order, so that all before one that fails are done.
  void work() {
    taut::Scene scene;
    bool blank = false;
    while (true) {
      const std::size_t begin = next_.fetch_add(chunk);
      const std::size_t end = std::min(begin + chunk, scenes_.size());
      for (std::size_t row = begin; row < end; ++row) {
        if (row > failed_ || options_.stop->load(std::memory_order_relaxed)) return;
        try {
          if (!blank) scene = scenes_.blank();
          blank = true;
          scenes_.fill(scene, row);
          answers_[row] = answer_row(taut::check(scene, options_), scene.bodies.size());
        } catch (...) {
          fail(row);
          return;
        }
      }
      if (end == scenes_.size()) return;
    }
  }

  void rethrow() const {
    if (!error_) return;
    const std::string row = "row " + std::to_string(failed_);
    try {
      std::rethrow_exception(error_);
    } catch (const taut::InputError& error) {
      throw error.within(row);
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

  const RowScenes& scenes_;
  const taut::CheckOptions& options_;
  AnswerRow* answers_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> failed_;
  std::mutex mutex_;
  std::exception_ptr error_;
};

}  // namespace

void check_rows(const RowScenes& scenes, const taut::CheckOptions& options, std::size_t threads, AnswerRow* answers) {
  Rows rows(scenes, options, answers);
  const std::size_t useful = std::min(threads, (scenes.size() + chunk - 1) / chunk);
  std::vector<std::thread> others;
  try {
    while (others.size() + 1 < useful) others.emplace_back([&rows] { rows.work(); });
  } catch (const std::system_error&) {
    // As many as the system gives.
  }
  rows.work();
  for (std::thread& other : others) other.join();
  rows.rethrow();
}

}  // namespace taut_python
