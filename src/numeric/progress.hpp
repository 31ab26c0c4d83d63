// The progress of a long query, for a user who waits for the answer.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

namespace taut::internal {

/// Written by the working thread, and read by one that displays it.
struct ProgressMeter {
  void set(const char* parts, std::uint64_t number, std::uint64_t total);

  std::atomic<const char*> kind{nullptr};      ///< the kind of parts counted, such as "pairs"
  std::atomic<std::uint64_t> done{0}, all{0};  ///< the numbers of parts; `all` is 0 if not known
  std::atomic<double> share{-1};               ///< of the whole query, from 0 to 1; below 0 if not known
  std::atomic<double> seconds_left{-1};        ///< expected; below 0 if not known
  std::atomic<double> time{-INFINITY};         ///< searched up to this instant of the scene
};

/// While it lives, the reports of this thread go to the meter.
class ProgressScope {
 public:
  explicit ProgressScope(ProgressMeter& meter);
  ~ProgressScope();
  ProgressScope(const ProgressScope&) = delete;
  ProgressScope& operator=(const ProgressScope&) = delete;

 private:
  ProgressMeter* outer_;
};

/// Reports that `done` parts of a kind are done, of `all`, if that is known. Without a scope, this has no effect.
void report_parts(const char* kind, std::uint64_t done, std::uint64_t all = 0);
/// Reports that the scene has been searched up to t, which is not earlier than reported before.
void report_time(double t);
/// Reports the share of the query that is decided.
void report_share(double share);

}  // namespace taut::internal
