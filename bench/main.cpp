// The benchmark program. Options are Google Benchmark's (--benchmark_filter=..., --benchmark_out=FILE, ...), and
// --short, the same as --benchmark_min_time=0.02: everything once or a few times, in less than a minute.
//
// In the table, Time is the processor time of what the row's name says; CPU includes the untimed preparation. Per event
// and per vertex: us/event, us/vertex. B/vertex is what the structure holds, peakB/vertex the most that was allocated
// while it was built. allocs: calls of operator new in the loop of events. precise: how often doubles did not suffice.
#include <unistd.h>

#include <cstdlib>
#include <string_view>
#include <vector>

#include "bench.hpp"

namespace taut::bench {
namespace {

bool failed = false;

/// The console table, without what is the same in every name.
class Table : public benchmark::ConsoleReporter {
 public:
  using ConsoleReporter::ConsoleReporter;
  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> plain = runs;
    for (Run& run : plain) {
      run.run_name.iterations.clear();
      run.run_name.time_type.clear();
    }
    ConsoleReporter::ReportRuns(plain);
  }
};

int run(int argc, char** argv) {
  constexpr std::string_view min_time = "--benchmark_min_time=";
  static char short_time[] = "--benchmark_min_time=0.02";
  bool quick = false;
  std::vector<char*> args(argv, argv + argc);
  for (char*& arg : args) {
    if (std::string_view(arg) == "--short") arg = short_time;
    if (std::string_view(arg).substr(0, min_time.size()) == min_time) {
      quick = std::strtod(arg + min_time.size(), nullptr) < 0.1;
    }
  }
  int count = static_cast<int>(args.size());
  benchmark::Initialize(&count, args.data());
  if (benchmark::ReportUnrecognizedArguments(count, args.data())) return 2;
  register_kinetic(quick);
  register_spacetime(quick);
  register_static(quick);
  register_static_map(quick);
  register_worlds(quick);
  Table table(isatty(STDOUT_FILENO) ? Table::OO_ColorTabular : Table::OO_Tabular);
  const std::size_t matched = benchmark::RunSpecifiedBenchmarks(&table);
  return failed || matched == 0 ? 1 : 0;
}

}  // namespace

void fail(benchmark::State& state, const std::string& what) {
  failed = true;
  state.SkipWithError(what.c_str());
}

}  // namespace taut::bench

int main(int argc, char** argv) { return taut::bench::run(argc, argv); }
