#include "batch.hpp"

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace taut::cli {
namespace {

/// Tasks for each thread that may be read before those ahead of them are done.
constexpr std::uint64_t ahead = 16;

class Batch {
 public:
  Batch(unsigned threads, const std::function<std::optional<BatchTask>()>& next,
        const std::function<BatchResult(const BatchTask&)>& work, const std::function<void(const BatchResult&)>& emit)
      : window_(ahead * threads), next_(next), work_(work), emit_(emit) {}

  void work_on() {
    std::unique_lock lock(mutex_);
    for (;;) {
      room_.wait(lock, [this] { return taken_ < emitted_ + window_; });
      if (exhausted_) return;
      const std::optional<BatchTask> task = next_();
      if (!task) {
        exhausted_ = true;
        return;
      }
      const std::uint64_t number = taken_++;
      lock.unlock();
      BatchResult result = work_(*task);
      lock.lock();
      done_.emplace(number, std::move(result));
      for (auto first = done_.find(emitted_); first != done_.end(); first = done_.find(emitted_)) {
        emit_(first->second);
        done_.erase(first);
        ++emitted_;
      }
      room_.notify_all();
    }
  }

 private:
  std::uint64_t window_;
  const std::function<std::optional<BatchTask>()>& next_;
  const std::function<BatchResult(const BatchTask&)>& work_;
  const std::function<void(const BatchResult&)>& emit_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::map<std::uint64_t, BatchResult> done_;  ///< results whose turn has not come
  std::uint64_t taken_ = 0, emitted_ = 0;
  bool exhausted_ = false;
};

}  // namespace

void run_batch(unsigned threads, const std::function<std::optional<BatchTask>()>& next,
               const std::function<BatchResult(const BatchTask&)>& work,
               const std::function<void(const BatchResult&)>& emit) {
  Batch batch(threads, next, work, emit);
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i) others.emplace_back([&batch] { batch.work_on(); });
  batch.work_on();
  for (std::thread& other : others) other.join();
}

}  // namespace taut::cli
