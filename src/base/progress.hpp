// How far a long question is, for somebody who waits for the answer.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

namespace taut::internal {

/// Written by the thread that works, and read by one that shows it.
struct ProgressMeter {
  void set(const char* parts, std::uint64_t number, std::uint64_t total);

  std::atomic<const char*> kind{nullptr};      ///< what is counted: "pairs", say
  std::atomic<std::uint64_t> done{0}, all{0};  ///< of these; `all` is 0 where it is not known
  std::atomic<double> share{-1};               ///< of the whole question, from 0 to 1; below 0 if it is not known
  std::atomic<double> time{-INFINITY};         ///< searched up to this instant of the scene
};

/// While it lives, what this thread reports goes to the meter.
class ProgressScope {
 public:
  explicit ProgressScope(ProgressMeter& meter);
  ~ProgressScope();
  ProgressScope(const ProgressScope&) = delete;
  ProgressScope& operator=(const ProgressScope&) = delete;

 private:
  ProgressMeter* outer_;
};

/// So many parts of a kind are done, of `all`, if that is known. Without a scope nothing happens.
void report_parts(const char* kind, std::uint64_t done, std::uint64_t all = 0);
/// The scene has been searched up to t: further than was reported before, or as far.
void report_time(double t);
/// This share of the question is decided.
void report_share(double share);

}  // namespace taut::internal
