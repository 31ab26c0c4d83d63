#include "base/interruption.hpp"

#include <algorithm>

namespace taut {
namespace {

thread_local InterruptionScope* innermost = nullptr;
thread_local unsigned calls = 0;

/// Longer limits than this are none.
constexpr double for_ever = 1e9;
constexpr unsigned stride = 64;

}  // namespace

InterruptionScope::InterruptionScope(const std::atomic<bool>* stop, double max_seconds)
    : stop_(stop), limited_(max_seconds < for_ever), outer_(innermost) {
  const std::chrono::duration<double> limit(std::max(max_seconds, 0.0));
  if (limited_) deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  innermost = this;
}

InterruptionScope::InterruptionScope(std::uint64_t effort) : effort_(effort / stride), outer_(innermost) {
  innermost = this;
  calls = 0;
}

InterruptionScope::~InterruptionScope() { innermost = outer_; }

void InterruptionScope::check() const {
  if (stop_ && stop_->load(std::memory_order_relaxed)) throw Interrupted{"interrupted"};
  if (limited_ && Clock::now() > deadline_) throw Interrupted{"the time limit was reached"};
  if (outer_) outer_->check();
}

/// At every `stride` interruption points.
void InterruptionScope::count() {
  check();
  if (effort_ == 0) {
    exhausted_ = true;
    throw Interrupted{"the effort was used up"};
  }
  --effort_;
}

void interruption_point() {
  if (innermost && ++calls % stride == 0) innermost->count();
}

}  // namespace taut
