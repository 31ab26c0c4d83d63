// Section 2.2: a change of plan changes the failure time of every certificate of the active set, and of nothing else.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "fit.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "runs.hpp"
#include "study.hpp"
#include "taut/simulation.hpp"

namespace taut::paper {
namespace {

Scene combs(int n) {
  gen::CombOptions o;
  o.teeth = (n / 2 - 2) / 4;
  return at_rest(gen::make_combs(o), 0);
}
Scene cup(int n) {
  gen::DipOptions o;
  o.sides = n - 8;
  o.dips = 1;
  return at_rest(gen::make_dips(o), 0);
}
Scene apart(int n) { return at_rest(convex_passing(n, 1), 0); }

/// Microseconds for one new plan with another velocity of up to `speed`, the next event found included.
double change_plans(Simulation& simulation, double speed, int changes) {
  gen::Random random(7);
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < changes; ++k) {
    const double vx = random.uniform(-speed, speed), vy = random.uniform(-speed, speed);
    simulation.set_motion(1, Motion{{gen::translation({0, vx}, {0, vy})}});
    simulation.next_event();
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  return 1e6 * spent.count() / changes;
}

}  // namespace

void study_locality(Output& output) {
  Table table("locality", {"family", "plans", "n", "active_set", "us_per_change", "us_per_certificate"});
  const std::vector<std::pair<std::string, Scene (*)(int)>> families = {
      {"combs, all teeth", combs}, {"disc in a cup", cup}, {"convex polygons apart", apart}};
  for (const auto& [name, make] : families) {
    for (const bool brisk : {true, false}) {
      // Within the scene's time the way is 1, or so short that no certificate can fail.
      const double speed = brisk ? 1 : 1e-3;
      for (int n = 64; n <= 16384; n *= 2) {
        Simulation simulation(make(n));
        change_plans(simulation, speed, 20);  // buffers grow
        double us = INFINITY;
        for (int repeat = 0; repeat < 5; ++repeat)
          us = std::min(us, change_plans(simulation, speed, simulation.certificates() > 2000 ? 20 : 200));
        const auto active = static_cast<double>(simulation.certificates());
        const std::size_t vertices = simulation.tiling().vertices.size();
        table.add({"\"" + name + "\"", brisk ? "brisk" : "gentle", cell(vertices), cell(active), cell(us, 4),
                   cell(us / active, 3)});
      }
    }
  }
  output.write(table);
  Plot plot{"Cost of a change of plan", {"certificates in the active set", 10}, {"microseconds per change", 10}, {}};
  for (const std::string& family : values(table, "family")) {
    for (const std::string& plans : values(table, "plans")) {
      Series s{fmt::format("{}: {}", family.substr(1, family.size() - 2), plans), {}};
      for (std::size_t i = 0; i < table.rows(); ++i) {
        if (table.text(i, "family") == family && table.text(i, "plans") == plans)
          s.points.emplace_back(table.number(i, "active_set"), table.number(i, "us_per_change"));
      }
      s.line = family.find("combs") != std::string::npos;
      if (s.line)
        output.note(
            fmt::format("locality, combs, {} plans: cost of a change grows as the active set to the power of {:.2f}",
                        plans, exponent(s.points)));
      plot.series.push_back(s);
    }
  }
  output.write("locality", plot);
}

}  // namespace taut::paper
