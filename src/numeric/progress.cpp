#include "numeric/progress.hpp"

#include <algorithm>
#include <utility>

namespace taut::internal {
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
