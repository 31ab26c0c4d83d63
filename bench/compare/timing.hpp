// Medians of processor time, and how they are printed.
#pragma once

#include <string>
#include <vector>

#include "stopwatch.hpp"

namespace taut::bench {

/// From now on this process runs on the core that it is on.
void pin_to_this_core();

/// "3.21 ms", with three digits.
std::string seconds_text(double seconds);

/// "One core of ..., compiler version ...".
std::string machine_text();

/// How long something takes, measured again and again.
class Timing {
 public:
  /// Runs `work` once more, or many times if it is short, and notes how long one run took.
  template <typename Work>
  void measure(const Work& work) {
    while (!measured(work)) {
    }
  }
  bool empty() const { return times_.empty(); }
  double last() const { return times_.back(); }
  double median() const;

 private:
  /// Runs too short for the clock do not count: the next time there are more of them.
  template <typename Work>
  bool measured(const Work& work) {
    const Stopwatch watch;
    for (int k = 0; k < batch_; ++k) work();
    return note(watch.seconds());
  }
  bool note(double seconds);

  std::vector<double> times_;
  int batch_ = 1;
};

}  // namespace taut::bench
