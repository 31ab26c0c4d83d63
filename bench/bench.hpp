// What the files of the benchmark program share.
#pragma once

#include <benchmark/benchmark.h>

#include <ctime>
#include <string>

namespace taut::bench {

/// A wrong answer: shown in the table, and the program will exit with 1.
void fail(benchmark::State& state, const std::string& what);

/// `quick`: as few repetitions as make sense.
void register_kinetic(bool quick);
void register_spacetime(bool quick);
void register_static(bool quick);

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
