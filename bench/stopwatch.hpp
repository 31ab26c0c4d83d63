// Processor time.
#pragma once

#include <ctime>

namespace taut::bench {

/// Processor time of this process, which has one thread: what else the machine does hardly matters.
class Stopwatch {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  double start_ = now();
};

}  // namespace taut::bench
