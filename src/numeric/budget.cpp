#include "numeric/budget.hpp"

#include "taut/error.hpp"

namespace taut::internal {
namespace {

thread_local Budget *innermost = nullptr;
thread_local std::uint64_t spent = 0, next_look = 0;

/// Limits longer than this count as no limit.
constexpr double for_ever = 1e9;
constexpr std::uint64_t between_looks = 64;

std::uint64_t after(std::uint64_t work, std::uint64_t more) {
  return more < UINT64_MAX - work ? work + more : UINT64_MAX;
}

} // namespace

Budget::Budget(const Limits &limits)
    : stop_(limits.stop), limited_(limits.max_seconds < for_ever),
      outer_(innermost) {
  if (!(limits.max_seconds >= 0))
    throw InputError("max_seconds", "it is negative or not a number",
                     "give 0 or more, or leave it out");
  const std::chrono::duration<double> limit(limits.max_seconds);
  if (limited_)
    deadline_ =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  innermost = this;
}

Budget::Budget(std::uint64_t effort)
    : end_(after(spent, effort)), outer_(innermost) {
  innermost = this;
  next_look = spent + between_looks;
}

Budget::Budget(const std::function<void()> &look)
    : look_(&look), outer_(innermost) {
  innermost = this;
}

Budget::~Budget() { innermost = outer_; }

void Budget::check() const {
  if (look_)
    (*look_)();
  if (stop_ && stop_->load(std::memory_order_relaxed))
    throw Interrupted{"interrupted"};
  if (limited_ && Clock::now() >= deadline_)
    throw Interrupted{"the time limit was reached"};
  if (outer_)
    outer_->check();
}

void Budget::test_limits() {
  check();
  if (spent >= end_)
    throw Interrupted{"the effort was used up"};
}

UnmeteredScope::UnmeteredScope()
    : spent_(spent), next_look_(next_look), unlimited_(UINT64_MAX) {}

UnmeteredScope::~UnmeteredScope() {
  spent = spent_;
  next_look = next_look_;
}

void checkpoint(std::uint64_t work) {
  spent += work;
  if (!innermost || spent < next_look)
    return;
  next_look = spent + between_looks;
  innermost->test_limits();
}

void count_work(std::uint64_t work) { spent += work; }

std::uint64_t work_spent() { return spent; }

Slice::Slice(std::uint64_t effort) : end_(after(spent, effort)) {}

} // namespace taut::internal
