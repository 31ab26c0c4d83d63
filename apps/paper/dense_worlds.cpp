// One pseudo-triangulation of the exterior of all bodies, beside tilings of pairs, in gases of elastic bodies.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "comparison/convex_separation.hpp"
#include "comparison/kinetic_tiling.hpp"
#include "comparison/worlds.hpp"
#include "sheet.hpp"
#include "study.hpp"
#include "taut/check.hpp"
#include "taut/pose.hpp"
#include "taut/simulation.hpp"
#include "world_picture.hpp"

namespace taut::paper {
namespace {

double allocated_bytes() { return static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd); }

struct DenseWorld {
  std::string family;
  double fraction = 0;
  int bodies = 0;
  std::uint64_t contacts = 0;
};

/// What the pseudo-triangulation needs for a recorded gas.
struct TilingOfAll {
  int edges = 0;
  std::uint64_t events = 0, certificates_max = 0, failure_times = 0;
  double certificates_mean = 0;  ///< over time
  double build_seconds = 0, seconds = 0;
  double bytes = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The bodies are shrunk by a millionth to two, so that at contacts they are apart by more than doubles round.
TilingOfAll follow(const Scene& record) {
  const Scene scene = shrunk(record, 1e-6, 1);
  const MovingBodies bodies(scene);
  TilingOfAll out;
  const auto start = std::chrono::steady_clock::now();
  KineticTiling tiling(bodies, scene.start, scene.end);
  out.build_seconds = seconds_since(start);
  double sum = 0, since = scene.start, bytes = 0;
  const auto run = std::chrono::steady_clock::now();
  while (true) {
    const auto certificates = static_cast<double>(tiling.certificates());
    const bool more = tiling.step();
    const double until = more ? tiling.time() : scene.end;
    sum += certificates * (until - since);
    since = until;
    if (!more) break;
    bytes = std::max(bytes, static_cast<double>(tiling.bytes()));
  }
  out.seconds = seconds_since(run);
  const std::string fault = find_fault(tiling.map(), bodies, bodies.positions(scene.end), false);
  if (!fault.empty() || tiling.late() > 0) throw std::runtime_error("a tiling of all bodies is none: " + fault);
  out.edges = tiling.map().free_edges();
  out.events = tiling.events();
  out.certificates_max = tiling.certificates_max();
  out.failure_times = tiling.failure_times();
  out.certificates_mean = sum / (scene.end - scene.start);
  out.bytes = bytes;
  return out;
}

/// Adds the row of a world.
void measure(const DenseWorld& world, Table& table) {
  const Polygon shape = gas_shape(world.family);
  const double before = allocated_bytes();
  double most = before;
  const SimulatedGas pairs = simulated_gas(shape, world.bodies, world.fraction, world.contacts, false,
                                           [&most] { most = std::max(most, allocated_bytes()); });
  const TilingOfAll all = follow(*simulated_gas(shape, world.bodies, world.fraction, world.contacts, true).record);
  const auto contacts = static_cast<double>(pairs.contacts);
  const auto each = [&](std::uint64_t count) { return cell(static_cast<double>(count) / contacts, 4); };
  const auto body = [&](double bytes) { return cell(bytes / world.bodies / 1024, 3); };
  table.add({world.family, cell(world.fraction), cell(world.bodies), cell(pairs.contacts),
             cell(pairs.certificates_mean, 5), cell(pairs.certificates_max), cell(all.certificates_mean, 5),
             cell(all.certificates_max), each(pairs.events), each(all.events), each(all.failure_times),
             cell(pairs.seconds / contacts * 1e6, 3), cell(all.seconds / contacts * 1e6, 3),
             cell(all.build_seconds * 1e3, 3), body(most - before), body(all.bytes)});
}

Plot plot_of_worlds(const Table& table) {
  Plot plot{"Certificates of gases: one tiling of all, and tilings of pairs",
            {"certificates of tilings of pairs, mean", 10},
            {"certificates of one tiling of all, mean", 10},
            {}};
  double least = INFINITY, most = 0;
  for (const std::string& family : values(table, "family")) {
    for (const std::string& fraction : values(table, "area_fraction")) {
      Series s{fmt::format("{}, {} of the area", family, fraction), {}};
      for (std::size_t i = 0; i < table.rows(); ++i) {
        if (table.text(i, "family") != family || table.text(i, "area_fraction") != fraction) continue;
        const double x = table.number(i, "pairs_certificates"), y = table.number(i, "all_certificates");
        least = std::min(least, x);
        most = std::max(most, x);
        s.points.emplace_back(x, y);
      }
      if (!s.points.empty()) plot.series.push_back(s);
    }
  }
  plot.series.push_back({"as many", {{least, least}, {most, most}}, true, false, true, 7});
  plot.series.push_back({"half as many", {{least, least / 2}, {most, most / 2}}, true, false, true, 8});
  return plot;
}

/// The least and the largest ratio of two columns.
void note_ratio(Output& output, const Table& table, const std::string& what, const std::string& all,
                const std::string& pairs) {
  std::pair<double, std::string> least{INFINITY, ""}, most{0, ""};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double ratio = table.number(i, all) / table.number(i, pairs);
    const std::string where =
        fmt::format("{} {}, {}", table.text(i, "bodies"), table.text(i, "family"), table.text(i, "area_fraction"));
    least = std::min(least, {ratio, where});
    most = std::max(most, {ratio, where});
  }
  output.note(fmt::format("worlds, {} of one tiling of all / of tilings of pairs: {:.2f} ({}) to {:.2f} ({})", what,
                          least.first, least.second, most.first, most.second));
}

/// The intervals of time in which the centres of two bodies are closer than `reach`, to a hundredth of a unit.
std::vector<TimeInterval> near_intervals(const Scene& scene, std::size_t one, std::size_t other, double reach) {
  constexpr double step = 0.01;
  std::vector<TimeInterval> out;
  for (double t = scene.start; t < scene.end; t += step) {
    const BodyPose a = pose_at(scene.bodies[one].motion, t), b = pose_at(scene.bodies[other].motion, t);
    if (std::hypot(a.origin.x - b.origin.x, a.origin.y - b.origin.y) >= reach) continue;
    const double until = std::min(t + step, scene.end);
    if (!out.empty() && out.back().hi >= t) {
      out.back().hi = until;
    } else {
      out.push_back({t, until});
    }
  }
  return out;
}

/// Events of separating lines, of all pairs of bodies while their discs, of radius 1, are closer than a tenth.
std::uint64_t events_of_lines(const Scene& record, std::size_t bodies) {
  const Scene scene = shrunk(record, 1e-6, 1);
  std::uint64_t events = 0;
  for (std::size_t i = 0; i < bodies; ++i) {
    for (std::size_t j = i + 1; j < bodies; ++j) {
      for (const TimeInterval& time : near_intervals(scene, i, j, 2.1)) {
        Scene pair;
        pair.start = time.lo;
        pair.end = time.hi;
        pair.bodies = {scene.bodies[i], scene.bodies[j]};
        ConvexSeparation lines(pair);
        while (lines.step()) {
        }
        events += lines.events();
      }
    }
  }
  return events;
}

/// How the cost of a contact grows with the vertices of round bodies: what events that do not grow could save.
void measure_round_bodies(Output& output) {
  Table table("worlds_round", {"family", "area_fraction", "bodies", "contacts", "certificates",
                               "pairs_events_per_contact", "lines_events_per_contact", "pairs_us_per_contact"});
  constexpr int bodies = 100, contacts = 1000;
  constexpr double fraction = 0.5;
  for (const char* family : {"6-gons", "16-gons", "32-gons", "64-gons", "128-gons", "256-gons"}) {
    const Polygon shape = gas_shape(family);
    const SimulatedGas gas = simulated_gas(shape, bodies, fraction, contacts, true);
    double seconds = INFINITY;
    for (int k = 0; k < 3; ++k)
      seconds = std::min(seconds, simulated_gas(shape, bodies, fraction, contacts, false).seconds);
    const auto each = [&](std::uint64_t count) {
      return cell(static_cast<double>(count) / static_cast<double>(gas.contacts), 4);
    };
    table.add({family, cell(fraction), cell(bodies), cell(gas.contacts), cell(gas.certificates_mean, 4),
               each(gas.events), each(events_of_lines(*gas.record, bodies)),
               cell(seconds / static_cast<double>(gas.contacts) * 1e6, 3)});
  }
  output.write(table);
}

/// The one tiling of 16 stars after 100 contacts, and the tilings of pairs that are near at the same time.
std::string picture_of_tilings() {
  const Scene scene = shrunk(*simulated_gas(gas_shape("stars"), 16, 0.5, 100, true).record, 1e-6, 1);
  const double t = (scene.start + 3 * scene.end) / 4;
  const MovingBodies bodies(scene);
  KineticTiling tiling(bodies, scene.start, t);
  while (tiling.step()) {
  }
  const std::vector<Point> at = bodies.positions(t);
  std::vector<Polygon> drawn;
  for (int body = 0; body < bodies.bodies(); ++body)
    drawn.emplace_back(at.begin() + bodies.first(body), at.begin() + bodies.first(body + 1));
  const auto edge = [&](int v, int w) {
    return DrawnEdge{at[static_cast<std::size_t>(v)], at[static_cast<std::size_t>(w)],
                     !bodies.rigid(bodies.body_of(v), bodies.body_of(w))};
  };
  std::vector<DrawnEdge> all, pairs;
  for (int h = 2 * bodies.vertices(); h < tiling.map().size(); h += 2)
    all.push_back(edge(tiling.map().origin(h), tiling.map().target(h)));
  // The bodies are drawn counterclockwise, so that their vertices have the same numbers.
  for (const NearTiling& near : tilings_of_near_pairs(scene, t)) {
    for (const NearEdge& e : near.edges)
      pairs.push_back(edge(bodies.first(e.from.body) + e.from.index, bodies.first(e.to.body) + e.to.index));
  }
  Sheet sheet(2);
  sheet.add(draw_world(drawn, all), "One tiling of all bodies");
  sheet.add(draw_world(drawn, pairs), "The tilings of pairs that are near");
  return sheet.draw();
}

}  // namespace

void study_worlds(Output& output) {
  Table table("worlds",
              {"family", "area_fraction", "bodies", "contacts", "pairs_certificates", "pairs_certificates_max",
               "all_certificates", "all_certificates_max", "pairs_events_per_contact", "all_events_per_contact",
               "all_failure_times_per_contact", "pairs_us_per_contact", "all_us_per_contact", "all_build_ms",
               "pairs_kib_per_body", "all_kib_per_body"});
  // Stars that turn have no room to begin at 0.7.
  const std::vector<std::pair<std::string, std::vector<double>>> families = {
      {"hexagons", {0.3, 0.5, 0.7}}, {"stars", {0.3, 0.5, 0.6}}, {"gears", {0.3, 0.5, 0.7}}};
  for (const auto& [family, fractions] : families) {
    for (const double fraction : fractions) {
      for (const int bodies : {50, 100, 200, 500, 1000}) {
        // Gears have 120 vertices each.
        if (family == "gears" && bodies > 200) continue;
        measure({family, fraction, bodies, static_cast<std::uint64_t>(10) * static_cast<std::uint64_t>(bodies)}, table);
      }
    }
  }
  output.write(table);
  output.write("worlds", plot_of_worlds(table));
  output.write_text("worlds_tilings.svg", picture_of_tilings());
  note_ratio(output, table, "certificates (mean)", "all_certificates", "pairs_certificates");
  note_ratio(output, table, "certificates (most)", "all_certificates_max", "pairs_certificates_max");
  note_ratio(output, table, "events", "all_events_per_contact", "pairs_events_per_contact");
  measure_round_bodies(output);
}

}  // namespace taut::paper
