// The comparison of engines: one process pinned to one core, the engines in turn on the same scenes, medians of
// processor time, ratios. A wrong answer fails.
#include <fmt/format.h>
#include <sched.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "compare/engines.hpp"
#include "stopwatch.hpp"

namespace taut::bench {
namespace {

struct Options {
  double seconds = 1;
  int largest = 65536;
  std::vector<std::string> only;
};

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

double median(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One row: every engine in turn, again and again. What the machine does meanwhile slows all of them down.
class Row {
 public:
  explicit Row(const Contest& contest) : contest_(contest) {
    for (const Column& column : columns()) {
      engines_.push_back(column.make());
      engines_.back()->set_up(contest);
    }
    times_.resize(engines_.size());
    batch_.resize(engines_.size(), 1);
  }

  /// What is wrong, or nothing.
  std::string run(double seconds) {
    const Stopwatch whole;
    for (int round = 0; round < 3 || (whole.seconds() < seconds && round < 101); ++round) {
      for (std::size_t i = 0; i < engines_.size(); ++i) {
        if (std::string wrong = once(i); !wrong.empty()) return std::string(columns()[i].name) + ": " + wrong;
      }
    }
    return {};
  }

  std::string text() {
    std::vector<double> medians;
    std::string line = fmt::format("| {} | {} ", contest_.family, contest_.n);
    for (std::vector<double>& t : times_) {
      medians.push_back(median(t));
      line += "| " + seconds_text(medians.back()) + " ";
    }
    // How many times faster the kinetic engine is than the second one, both with prepared shapes.
    return line + fmt::format("| {:.2g} |", medians[3] / medians[1]);
  }

 private:
  std::string once(std::size_t i) {
    std::vector<Answer> answers;
    const Stopwatch watch;
    for (int k = 0; k < batch_[i]; ++k) answers = engines_[i]->run();
    const double seconds = watch.seconds();
    times_[i].push_back(seconds / batch_[i]);
    // Short runs are timed many at a time.
    if (seconds < 2e-4 && batch_[i] < 1000) {
      batch_[i] = std::min(1000, static_cast<int>(batch_[i] * 4e-4 / std::max(seconds, 1e-7)) + 1);
      times_[i].pop_back();
      return once(i);
    }
    return fault(contest_, answers);
  }

  const Contest& contest_;
  std::vector<std::unique_ptr<Engine>> engines_;
  std::vector<std::vector<double>> times_;
  std::vector<int> batch_;
};

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "an unknown processor";
}

int compare(const Options& options) {
  pin_to_this_core();
  fmt::print("One core of {}, compiler version {}.\n\n", processor(), __VERSION__);
  fmt::print("| family | n ");
  std::string rule = "|---|---:";
  for (const Column& column : columns()) {
    fmt::print("| {} ", column.name);
    rule += "|---:";
  }
  fmt::print("| ratio |\n{}|---:|\n", rule);
  bool right = true;
  for (const ContestFamily& family : contest_families()) {
    if (!options.only.empty() && std::find(options.only.begin(), options.only.end(), family.name) == options.only.end())
      continue;
    for (const int n : family.sizes) {
      if (n > options.largest) continue;
      const Contest contest = family.make(n);
      Row row(contest);
      const std::string wrong = row.run(options.seconds);
      right = right && wrong.empty();
      fmt::print("{}\n", wrong.empty() ? row.text() : fmt::format("| {} | {} | WRONG: {} |", family.name, n, wrong));
      std::fflush(stdout);
    }
  }
  return right ? 0 : 1;
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  CLI::App app("Compares taut's engines on the same scenes in one run");
  taut::bench::Options options;
  app.add_option("--seconds", options.seconds, "Processor time for each row");
  app.add_option("--largest", options.largest, "Leave out larger polygons");
  app.add_option("--only", options.only, "Families");
  CLI11_PARSE(app, argc, argv);
  try {
    return taut::bench::compare(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
