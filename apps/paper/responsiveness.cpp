// Section 2.3: an event changes a constant number of edges and certificates, and costs O(log n) time.
#include <fmt/format.h>

#include <algorithm>

#include "runs.hpp"
#include "study.hpp"

namespace taut::paper {

void study_responsiveness(Output& output) {
  Table table("responsiveness", {"family", "n", "events", "certificates_max", "corners_touched_max",
                                 "edges_changed_max", "us_per_event"});
  int corners = 0, edges = 0;
  const std::vector<std::pair<std::string, Scene (*)(int)>> families = {
      {"Fig. 16, 4 dips", [](int n) { return fig16(8, n - 8); }},
      {"Fig. 17", [](int n) { return fig17(n / 2); }},
      {"combs leaving", [](int n) { return combs_leaving(n, 1); }},
      {"convex polygons passing", [](int n) { return convex_passing(n, 1); }},
      {"convex polygons turning", [](int n) { return convex_turning(n, 1); }},
  };
  for (const auto& [name, make] : families) {
    for (int n = 64; n <= (name == "Fig. 17" ? 512 : 16384); n *= 2) {
      const Run run = run_free(make(n), 5);
      if (run.events == 0) continue;
      corners = std::max(corners, run.corners_touched);
      edges = std::max(edges, run.edges_changed);
      table.add({"\"" + name + "\"", cell(run.vertices), cell(run.events), cell(run.certificates_max),
                 cell(run.corners_touched), cell(run.edges_changed),
                 cell(1e6 * run.seconds / static_cast<double>(run.events), 3)});
    }
  }
  output.write(table);
  Plot plot{"Time per event", {"n, vertices of both polygons", 2}, {"microseconds per event", 10}, {}};
  for (const std::string& family : values(table, "family"))
    plot.series.push_back({family.substr(1, family.size() - 2), samples(table, "n", "us_per_event", "family", family)});
  output.write("responsiveness", plot);
  output.note(fmt::format("responsiveness: {} runs; most corners touched by one repair: {}; most edges changed: {}",
                          table.rows(), corners, edges));
}

}  // namespace taut::paper
