#include "compare/timing.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <fstream>

namespace taut::bench {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "an unknown processor";
}

}  // namespace

void pin_to_this_core() {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<unsigned>(sched_getcpu()), &set);
  sched_setaffinity(0, sizeof set, &set);
}

std::string seconds_text(double s) {
  const char* const units[] = {"s", "ms", "us"};
  int unit = 0;
  for (; unit < 2 && s < 1; ++unit) s *= 1000;
  return fmt::format("{:.3g} {}", s, units[unit]);
}

std::string machine_text() { return fmt::format("One core of {}, compiler version {}.", processor(), __VERSION__); }

double Timing::median() const {
  std::vector<double> values = times_;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

bool Timing::note(double seconds) {
  if (seconds < 2e-4 && batch_ < 1000) {
    batch_ = std::min(1000, static_cast<int>(batch_ * 4e-4 / std::max(seconds, 1e-7)) + 1);
    return false;
  }
  times_.push_back(seconds / batch_);
  return true;
}

}  // namespace taut::bench
