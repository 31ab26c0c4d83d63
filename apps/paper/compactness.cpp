// Lemma 2.4 and Theorem 2.6: with kappa the size of a minimum-link separator, the active set has at most
// 4 (2 kappa (2 + log2 n - log2 kappa) + 2 kappa) certificates: the proof's sum, times four corners an edge.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "coastline.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "runs.hpp"
#include "study.hpp"
#include "taut/separator.hpp"
#include "taut/simulation.hpp"

namespace taut::paper {
namespace {

struct Situation {
  std::string family;
  Scene scene;
};

Scene shifted(Scene scene, double dx, double dy) {
  for (Point& p : scene.bodies[1].polygon) p = {p.x + dx, p.y + dy};
  return scene;
}

Scene interlocked_combs(int n) {
  gen::CombOptions o;
  o.teeth = std::max(1, (n / 2 - 2) / 4);
  return at_rest(gen::make_combs(o), 0);
}

Scene islands(int n) {
  Scene scene;
  const auto half = static_cast<std::size_t>(n / 2);
  scene.end = 1;
  scene.bodies = {{"one", bench::island(half, 3), {}}, {"other", bench::island(half, 4), {}}};
  return shifted(scene, 3, 0.37);
}

/// From far apart to fully interlocked, n vertices in all, about.
std::vector<Situation> placements(int n) {
  std::vector<Situation> out;
  out.push_back({"islands apart", islands(n)});
  gen::DipOptions dip;
  dip.sides = std::max(3, n - 8);
  dip.dips = 1;
  out.push_back({"disc in a cup", at_rest(gen::make_dips(dip), 0)});
  if (n >= 256) out.push_back({"gears", at_rest(gears(n), 0.01)});
  if (n >= 256) {
    gen::SpiralOptions spiral;
    spiral.side_points = n / 4;
    spiral.turns = 2;
    out.push_back({"spirals, 2 turns", at_rest(gen::make_spiral(spiral), 0)});
  }
  if (n >= 128) out.push_back({"headland in a bay", at_rest(bench::bay(static_cast<std::size_t>(n)), 0)});
  const Scene interlocked = interlocked_combs(n);
  const int teeth = static_cast<int>(interlocked.bodies[0].polygon.size() - 2) / 4;
  // Shifted along by all but m teeth, m slots are shared.
  for (const auto& [name, m] : {std::pair<std::string, double>{"combs, 2 teeth", 2},
                                {"combs, sqrt of all teeth", std::sqrt(teeth)},
                                {"combs, half of the teeth", teeth / 2}}) {
    const int share = static_cast<int>(m);
    if (share < 2 || share >= teeth) continue;
    out.push_back({name, shifted(interlocked, teeth - share, 0)});
  }
  out.push_back({"combs, all teeth", interlocked});
  return out;
}

/// The largest value of something, and where it was.
struct Largest {
  double value = 0;
  std::string where;
  void see(double v, const std::string& place) {
    if (v > value) value = v, where = place;
  }
};

struct Extremes {
  Largest share_of_bound, constant;
};

/// Adds the row of a placement.
void measure(const Situation& placement, Table& table, Extremes& extremes) {
  const Scene& scene = placement.scene;
  const auto vertices = static_cast<double>(scene.bodies[0].polygon.size() + scene.bodies[1].polygon.size());
  const Separator found = separator(scene, scene.start);
  const Simulation simulation(scene);
  const auto active = static_cast<double>(simulation.certificates());
  const double kappa = found.minimum_link.lower;
  const double bound = 4 * (2 * kappa * (2 + std::log2(vertices) - std::log2(kappa)) + 2 * kappa);
  const double constant = active / (kappa * (1 + std::log2(vertices / kappa)));
  const std::string place = fmt::format("{}, n = {}", placement.family, vertices);
  extremes.share_of_bound.see(active / bound, place);
  extremes.constant.see(constant, place);
  table.add({"\"" + placement.family + "\"", cell(vertices), cell(found.minimum_link.lower),
             cell(found.minimum_link.upper), cell(active),
             cell(found.moving.bichromatic_edges[0] + found.moving.bichromatic_edges[1]), cell(bound),
             cell(active / bound, 3), cell(constant, 3)});
}

/// The table's rows over what they are compared with, a series for each family.
Plot plot_of(const Table& table, double largest_constant) {
  Plot plot;
  plot.title = "Active set and the size of a separator (Lemma 2.4)";
  plot.x = {"kappa log2(2n / kappa)", 10};
  plot.y = {"certificates in the active set", 10};
  double most = 0, least = INFINITY;
  std::map<std::string, Series> by_family;
  std::vector<std::string> order;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double n = table.number(i, "n"), kappa = table.number(i, "kappa_lower"),
                 x = kappa * (1 + std::log2(n / kappa));
    const std::string family = table.text(i, "family");
    if (!by_family.count(family)) order.push_back(family);
    Series& s = by_family[family];
    s.label = family.substr(1, family.size() - 2);
    s.line = false;
    s.points.emplace_back(x, table.number(i, "active_set"));
    most = std::max(most, x);
    least = std::min(least, x);
  }
  for (const std::string& family : order) plot.series.push_back(by_family[family]);
  // A straight line through 0, of so many certificates for each unit of x.
  const auto line = [&](const std::string& label, double slope, int colour) {
    plot.series.push_back({label, {{least, slope * least}, {most, slope * most}}, true, false, true, colour});
  };
  // 4 (2 kappa (2 + L) + 2 kappa) with L = log2(n/kappa) is 8 kappa (3 + L), between 8 and 24 times kappa (1 + L).
  line("the proof allows 8 x and more", 8, 6);
  line(fmt::format("largest seen: {:.2f} x", largest_constant), largest_constant, 7);
  return plot;
}

}  // namespace

void study_compactness(Output& output) {
  Table table("compactness", {"family", "n", "kappa_lower", "kappa_upper", "active_set", "pq_edges_hulls",
                              "proof_bound", "share_of_bound", "active_per_kappa_log"});
  Extremes extremes;
  for (int n = 16; n <= 16384; n *= 2) {
    for (const Situation& placement : placements(n)) measure(placement, table, extremes);
  }
  output.write(table);
  output.write("compactness", plot_of(table, extremes.constant.value));
  output.note(
      fmt::format("compactness: {} placements; largest active set / (kappa (1 + log2(n/kappa))) = {:.3f} ({}); largest "
                  "share of the proof's bound = {:.3f} ({})",
                  table.rows(), extremes.constant.value, extremes.constant.where, extremes.share_of_bound.value,
                  extremes.share_of_bound.where));
}

}  // namespace taut::paper
