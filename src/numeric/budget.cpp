#include "numeric/budget.hpp"

#include <algorithm>
#include <utility>

#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// Of this thread; together, since in a shared library each variable of a thread costs a call to be found.
struct ThreadWork {
  Budget* innermost = nullptr;
  std::uint64_t spent = 0, next_look = 0;
};
thread_local ThreadWork mine;

/// Limits longer than this count as no limit.
constexpr double for_ever = 1e9;
constexpr std::uint64_t between_looks = 64;

std::uint64_t after(std::uint64_t work, std::uint64_t more) {
  return more < UINT64_MAX - work ? work + more : UINT64_MAX;
}

}  // namespace

Budget::Budget(const Limits& limits)
    : stop_(limits.stop), limited_(limits.max_seconds < for_ever), outer_(mine.innermost) {
  if (!(limits.max_seconds >= 0))
    throw InputError("max_seconds", "it is negative or not a number", "give 0 or more, or leave it out");
  const std::chrono::duration<double> limit(limits.max_seconds);
  if (limited_) deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  mine.innermost = this;
}

Budget::Budget(std::uint64_t effort) : end_(after(mine.spent, effort)), outer_(mine.innermost) {
  mine.innermost = this;
  mine.next_look = mine.spent + between_looks;
}

Budget::Budget(const std::function<void()>& look) : look_(&look), outer_(mine.innermost) { mine.innermost = this; }

Budget::~Budget() { mine.innermost = outer_; }

void Budget::check() const {
  if (look_) (*look_)();
  if (stop_ && stop_->load(std::memory_order_relaxed)) throw Interrupted{"interrupted"};
  if (limited_ && Clock::now() >= deadline_) throw Interrupted{"the time limit was reached"};
  if (outer_) outer_->check();
}

void Budget::test_limits() {
  check();
  if (mine.spent >= end_) throw Interrupted{"the effort was used up"};
}

UnmeteredScope::UnmeteredScope() : spent_(mine.spent), next_look_(mine.next_look), unlimited_(UINT64_MAX) {}

UnmeteredScope::~UnmeteredScope() {
  mine.spent = spent_;
  mine.next_look = next_look_;
}

void checkpoint(std::uint64_t work) {
  mine.spent += work;
  if (!mine.innermost || mine.spent < mine.next_look) return;
  mine.next_look = mine.spent + between_looks;
  mine.innermost->test_limits();
}

void count_work(std::uint64_t work) { mine.spent += work; }

std::uint64_t work_spent() { return mine.spent; }

Slice::Slice(std::uint64_t effort) : end_(after(mine.spent, effort)) {}

namespace {

thread_local ProgressMeter* meter_of_thread = nullptr;

}  // namespace

void ProgressMeter::set(const char* parts, std::uint64_t number, std::uint64_t total) {
  kind.store(parts, std::memory_order_relaxed);
  done.store(number, std::memory_order_relaxed);
  all.store(total, std::memory_order_relaxed);
}

ProgressScope::ProgressScope(ProgressMeter& meter) : outer_(std::exchange(meter_of_thread, &meter)) {}
ProgressScope::~ProgressScope() { meter_of_thread = outer_; }

void report_parts(const char* kind, std::uint64_t done, std::uint64_t all) {
  if (meter_of_thread) meter_of_thread->set(kind, done, all);
}

void report_time(double t) {
  if (!meter_of_thread) return;
  std::atomic<double>& time = meter_of_thread->time;
  time.store(std::max(time.load(std::memory_order_relaxed), t), std::memory_order_relaxed);
}

void report_share(double share) {
  if (meter_of_thread) meter_of_thread->share.store(share, std::memory_order_relaxed);
}

}  // namespace taut::internal
