#include "numeric/interruption.hpp"

namespace taut {
namespace {

thread_local const InterruptionScope* innermost = nullptr;
thread_local unsigned calls = 0;

/// Longer limits than this are none.
constexpr double for_ever = 1e9;

}  // namespace

InterruptionScope::InterruptionScope(const std::atomic<bool>* stop, double max_seconds)
    : stop_(stop), limited_(max_seconds < for_ever), outer_(innermost) {
  if (limited_)
    deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(max_seconds));
  innermost = this;
}

InterruptionScope::~InterruptionScope() { innermost = outer_; }

void InterruptionScope::check() const {
  if (stop_ && stop_->load(std::memory_order_relaxed)) throw Interrupted{"interrupted"};
  if (limited_ && Clock::now() > deadline_) throw Interrupted{"the time limit was reached"};
}

void interruption_point() {
  if (innermost && ++calls % 64 == 0) innermost->check();
}

}  // namespace taut
