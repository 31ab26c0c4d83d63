// Theorems 3.1 and 3.2: how many events there are.
#include <fmt/format.h>

#include <cmath>

#include "fit.hpp"
#include "runs.hpp"
#include "study.hpp"

namespace taut::paper {
namespace {

double n_log_n(double n) { return n * std::log2(n); }
double linear(double n) { return n; }

/// Theorem 3.1 on Fig. 16: omega(kn) events. Here k is the degree of the path: twice the number of dips.
void translations_of_fig16(Output& output) {
  Table table("fig16", {"k", "n", "events", "events_per_kn"});
  for (const int k : {2, 4, 8, 16, 32}) {
    for (int n = 16; n <= 16384; n *= 2) {
      const Run run = run_free(fig16(k, n));
      table.add({cell(k), cell(n), cell(run.events), cell(static_cast<double>(run.events) / k / n, 4)});
    }
  }
  output.write(table);
  Plot plot{"Fig. 16: events of k/2 dips of a regular n-gon", {"n", 2}, {"events", 10}, {}};
  for (const std::string& k : values(table, "k")) {
    const Samples s = samples(table, "n", "events", "k", k);
    const Fit a = fit(s, linear), b = fit(s, n_log_n);
    plot.series.push_back({"k = " + k + fmt::format(": {:.2f} kn", a.factor / std::stod(k)), s});
    output.note(
        fmt::format("fig16: k = {}: exponent of n {:.3f}; {:.3f} kn within {:.1f} %, {:.4f} kn log2 n within {:.1f} %",
                    k, exponent(s), a.factor / std::stod(k), 100 * a.error, b.factor / std::stod(k), 100 * b.error));
  }
  output.write("fig16_events", plot);
}

void random_translations(Output& output) {
  Table table("random_translations", {"family", "degree", "seed", "n", "events", "events_per_kn"});
  constexpr int degree = 4;
  for (int n = 32; n <= 16384; n *= 2) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      for (const bool combs : {true, false}) {
        const Run run = run_free(combs ? combs_leaving(n, seed) : convex_passing(n, seed));
        table.add({combs ? "combs leaving" : "convex polygons passing", cell(degree), cell(seed), cell(run.vertices),
                   cell(run.events),
                   cell(static_cast<double>(run.events) / degree / static_cast<double>(run.vertices), 4)});
      }
    }
  }
  output.write(table);
  Plot plot{"Random translations", {"n, vertices of both polygons", 2}, {"events", 10}, {}};
  for (const std::string& family : values(table, "family")) {
    const Samples s = samples(table, "n", "events", "family", family);
    Series series{family, s};
    series.line = false;
    plot.series.push_back(series);
    const Fit a = fit(s, linear), b = fit(s, n_log_n);
    plot.series.push_back({fmt::format("{:.3g} n log2 n", b.factor),
                           {{32, b.factor * n_log_n(32)}, {16384, b.factor * n_log_n(16384)}},
                           true,
                           false,
                           true});
    output.note(fmt::format(
        "random translations, {}: exponent of n {:.3f}; {:.3f} n within {:.0f} %, {:.4f} n log2 n within {:.0f} %",
        family, exponent(s), a.factor, 100 * a.error, b.factor, 100 * b.error));
  }
  output.write("random_translations", plot);
}

void rigid_motions(Output& output) {
  Table table("rigid_motions", {"family", "seed", "n", "events", "events_per_n2"});
  const auto add = [&table](const std::string& family, std::uint64_t seed, const Scene& scene) {
    const Run run = run_free(scene);
    const auto n = static_cast<double>(run.vertices), events = static_cast<double>(run.events);
    table.add({family, cell(seed), cell(run.vertices), cell(run.events), cell(events / n / n, 4)});
  };
  for (int n = 16; n <= 512; n *= 2) add("Fig. 17", 0, fig17(n));
  for (int n = 256; n <= 8192; n *= 2) add("gears, one turn", 0, gears(n));
  for (int n = 128; n <= 8192; n *= 2) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      add("convex polygons turning", seed, convex_turning(n, seed));
    }
  }
  output.write(table);
  Plot plot{"Rigid motions (Theorem 3.2)", {"n, vertices of both polygons", 2}, {"events", 10}, {}};
  for (const std::string& family : values(table, "family")) {
    const Samples s = samples(table, "n", "events", "family", family);
    const double b = exponent(s);
    Series series{fmt::format("{}: exponent {:.2f}", family, b), s};
    series.line = family == "Fig. 17";
    plot.series.push_back(series);
    output.note(fmt::format("rigid motions, {}: exponent of n {:.3f}", family, b));
  }
  output.write("rigid_motions", plot);
}

}  // namespace

void study_efficiency(Output& output) {
  translations_of_fig16(output);
  random_translations(output);
  rigid_motions(output);
}

}  // namespace taut::paper
