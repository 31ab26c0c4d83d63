// The comparison of engines: one process pinned to one core, the engines in turn on the same scenes, medians of
// processor time, ratios. A wrong answer fails.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "command_line/command_line.hpp"
#include "compare/engines.hpp"
#include "compare/ties.hpp"
#include "compare/timing.hpp"

namespace taut::bench {
namespace {

struct Options {
  double seconds = 1;
  int largest = 400000;
  std::vector<std::string> only;
  bool ties = false;
};

/// One row: every engine in turn, again and again. What the machine does meanwhile slows all of them down.
class Row {
 public:
  explicit Row(const Contest& contest) : contest_(contest) {
    for (const Column& column : columns()) {
      engines_.push_back(column.make());
      engines_.back()->set_up(contest);
    }
    timings_.resize(engines_.size());
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
    for (const Timing& timing : timings_) {
      medians.push_back(timing.median());
      line += "| " + seconds_text(medians.back()) + " ";
    }
    // How many times faster the kinetic engine is than the second one, both with prepared shapes.
    return line + fmt::format("| {:.2g} |", medians[3] / medians[1]);
  }

 private:
  std::string once(std::size_t i) {
    std::vector<Answer> answers;
    timings_[i].measure([&] { answers = engines_[i]->run(); });
    if (std::string wrong = fault(contest_, answers); !wrong.empty()) return wrong;
    if (first_.empty()) first_ = answers;
    return disagreement(first_, answers);
  }

  const Contest& contest_;
  std::vector<std::unique_ptr<Engine>> engines_;
  std::vector<Timing> timings_;
  std::vector<Answer> first_;  ///< what the first engine said
};

int compare(const Options& options) {
  pin_to_this_core();
  fmt::print("{}\n\n", machine_text());
  fmt::print("| family | n ");
  std::string rule = "|---|---:";
  for (const Column& column : columns()) {
    fmt::print("| {} ", column.name);
    rule += "|---:";
  }
  fmt::print("| ratio |\n{}|---:|\n", rule);
  bool right = true;
  for (const ContestFamily& family : chosen_families(options.only)) {
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
  taut::cli::Program program("Compares taut's engines on the same scenes in one run", "taut_compare");
  const taut::cli::Command app = program.command();
  taut::bench::Options options;
  app.add_option("--seconds", options.seconds, "Processor time for each row");
  app.add_option("--largest", options.largest, "Leave out larger polygons");
  app.add_option("--only", options.only, "Families");
  app.add_flag("--ties", options.ties, "Compare scenes drawn on a grid with nudged ones instead");
  return taut::cli::run_program(program, argc, argv, [&] {
    if (!options.ties) return taut::bench::compare(options);
    taut::bench::pin_to_this_core();
    return taut::bench::compare_ties(options.seconds) ? 0 : 1;
  });
}
