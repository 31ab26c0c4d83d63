// A pointed pseudo-triangulation of two bodies, and separating lines of convex hulls, beside the tiling.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "comparison/convex_separation.hpp"
#include "comparison/kinetic_tiling.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "runs.hpp"
#include "study.hpp"
#include "taut/separator.hpp"

namespace taut::paper {
namespace {

struct PairFamily {
  std::string name;
  bool convex = false, in_line = false;  ///< vertices may be in line
  std::function<Scene(int)> make;
  int smallest = 32, largest = 1024;
};

Scene interlocked(int n) {
  gen::CombOptions o;
  o.teeth = std::max(2, (n / 2 - 2) / 4);
  return gen::make_combs(o);
}
Scene spiral(int n) {
  gen::SpiralOptions o;
  o.side_points = n / 4;
  return gen::make_spiral(o);
}
/// Two regular polygons side by side, of radius 1 and a hundredth apart, that turn once, in opposite directions.
Scene wheels(int n) {
  Scene scene;
  scene.end = 1;
  for (int k = 0; k < 2; ++k) {
    Polygon ring;
    for (int i = 0; i < n / 2; ++i) ring.push_back(gen::polar(1, 2 * gen::pi * (i + 0.3 * k) / (n / 2)));
    MotionPiece piece = gen::translation({2.01 * k}, {});
    piece.rotation = AngleRotation{{0, (k ? -1 : 1) * 2 * gen::pi}};
    scene.bodies.push_back({k ? "right" : "left", ring, Motion{{piece}}});
  }
  return scene;
}
/// Convex polygons that pass and turn, with so much more room between them.
Scene turning_at(int n, double room) {
  Scene scene = convex_turning(n, 1);
  scene.bodies[1].motion.pieces[0].x[0] += room;
  return scene;
}

std::vector<PairFamily> pair_families() {
  return {{"combs, to and fro", false, true, interlocked, 32, 1024},
          {"combs, leaving", false, true, [](int n) { return combs_leaving(n, 1); }, 32, 1024},
          {"dips (Fig. 16)", false, true, [](int n) { return fig16(8, n); }, 32, 1024},
          {"rotor (Fig. 17)", false, false, [](int n) { return fig17(n / 2); }, 32, 1024},
          {"gears", false, true, gears, 256, 1024},
          {"spiral", false, true, spiral, 256, 1024},
          {"convex, passing", true, true, [](int n) { return convex_passing(n, 1); }, 16, 1024},
          {"convex, turning", true, true, [](int n) { return turning_at(n, 0); }, 16, 1024},
          {"convex, turning far away", true, true, [](int n) { return turning_at(n, 100); }, 16, 1024},
          {"wheels", true, true, wheels, 16, 1024}};
}

/// Milliseconds that the other engine takes: the least of three runs.
double spacetime_ms(const Scene& scene) {
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  double least = INFINITY;
  for (int k = 0; k < 3; ++k) least = std::min(least, check(scene, options).run_seconds * 1e3);
  return least;
}

/// Adds the row of a scene. Where its vertices are in line, they are moved by a hundred-millionth at most, and both
/// structures are asked about that. The rotor's must not be: its chain is flatter.
void measure_pair(const PairFamily& family, const Scene& given, Table& table) {
  const Scene scene = family.in_line ? jittered(given, 1e-8, 3) : given;
  const Run tiling = run_free(scene, 3);
  const int kappa = separator(scene, scene.start).minimum_link.upper;
  const MovingBodies bodies(scene);
  KineticTiling pointed(bodies, scene.start, scene.end);
  const std::uint64_t at_start = pointed.certificates();
  while (pointed.step()) {
  }
  const std::string fault = find_fault(pointed.map(), bodies, bodies.positions(scene.end), false);
  if (!fault.empty()) throw std::runtime_error("a pointed tiling is none: " + family.name + ": " + fault);
  std::optional<ConvexSeparation> lines;
  if (family.convex) lines.emplace(scene);
  while (lines && lines->step()) {
  }
  table.add({"\"" + family.name + "\"", cell(tiling.vertices), cell(kappa), cell(tiling.certificates_max),
             cell(at_start), cell(pointed.certificates_max()), lines ? cell(ConvexSeparation::certificates) : "",
             cell(tiling.events), cell(pointed.events()), lines ? cell(lines->events()) : "",
             cell(tiling.seconds * 1e3, 3), cell(spacetime_ms(scene), 3)});
}

/// The last row of a family: the largest scene.
std::size_t last_row(const Table& table, const std::string& family) {
  std::size_t row = 0;
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (table.text(i, "family") == family) row = i;
  return row;
}

/// A series for each family: the lines of convex bodies, the pointed tilings of others.
Plot plot_of_pairs(const Table& table) {
  Plot plot{"Events of pairs: other structures, and the tiling",
            {"events of the tiling", 10},
            {"events of the other structure", 10},
            {}};
  double least = INFINITY, most = 0;
  for (const std::string& family : values(table, "family")) {
    const bool lines = !table.text(last_row(table, family), "lines_events").empty();
    Series s{family.substr(1, family.size() - 2) + (lines ? ": lines" : ": pointed"),
             samples(table, "tiling_events", lines ? "lines_events" : "pointed_events", "family", family)};
    for (const auto& [x, y] : s.points) least = std::min(least, x), most = std::max(most, x);
    plot.series.push_back(s);
  }
  plot.series.push_back({"as many", {{least, least}, {most, most}}, true, false, true, 7});
  plot.series.push_back({"half as many", {{least, least / 2}, {most, most / 2}}, true, false, true, 8});
  return plot;
}

}  // namespace

void study_structures(Output& output) {
  Table table("structures", {"family", "n", "kappa_start", "tiling_certificates", "pointed_certificates_start",
                             "pointed_certificates", "lines_certificates", "tiling_events", "pointed_events",
                             "lines_events", "tiling_ms", "spacetime_ms"});
  for (const PairFamily& family : pair_families()) {
    for (int n = family.smallest; n <= family.largest; n *= 2) measure_pair(family, family.make(n), table);
  }
  output.write(table);
  output.write("structures", plot_of_pairs(table));
  for (const std::string& family : values(table, "family")) {
    const std::size_t last = last_row(table, family);
    const auto ratio = [&](const std::string& column, const std::string& tiling) {
      return table.number(last, column) / table.number(last, tiling);
    };
    const std::string lines = table.text(last, "lines_events").empty()
                                  ? ""
                                  : fmt::format("; lines: {} events", table.text(last, "lines_events"));
    output.note(fmt::format("structures, {}, n = {}: pointed / tiling: certificates {:.2f}, events {:.2f}{}",
                            family.substr(1, family.size() - 2), table.text(last, "n"),
                            ratio("pointed_certificates", "tiling_certificates"),
                            ratio("pointed_events", "tiling_events"), lines));
  }
}

}  // namespace taut::paper
