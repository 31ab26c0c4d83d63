// Event-driven dynamics: contacts a second, memory and drift of energy of gases of polygons.
//
//   taut_dynamics [--bodies N]... [--vertices V] [--fraction F] [--contacts M] [--changes K]
#include <fmt/format.h>
#include <malloc.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "dynamics/gas.hpp"
#include "stopwatch.hpp"
#include "taut/simulation.hpp"

namespace taut::bench {
namespace {

double allocated() { return static_cast<double>(mallinfo2().uordblks + mallinfo2().hblkhd); }

void run(int count, int vertices, double fraction, std::uint64_t most) {
  Gas start = gas(count, vertices, fraction);
  elastic::Collisions collisions(start.bodies, 0x1p-44 * start.side);
  const double before = allocated(), energy = collisions.energy();
  const Point momentum = collisions.momentum();
  const Stopwatch building;
  Simulation simulation(start.scene);
  const double build = building.seconds();
  double largest = 0;
  const Stopwatch watch;
  std::uint64_t again = 0;
  while (simulation.contacts() < most && simulation.advance_to(start.scene.end) == SimulationState::contact) {
    again += simulation.contact_again();
    collisions.respond(simulation);
    if (simulation.contacts() % 64 == 0) largest = std::max(largest, allocated());
  }
  const double seconds = watch.seconds();
  if (simulation.contacts() < most) fmt::print("# {} {}\n", to_string(simulation.state()), simulation.reason());
  const double contacts = static_cast<double>(simulation.contacts());
  fmt::print(
      "{:>7} {:>3} {:>5.2f} {:>8} {:>6} {:>9.1f} {:>9.0f} {:>9.1f} {:>8.1f} {:>9.1f} {:>9.1e} {:>9.1e}\n", count,
      vertices, fraction, simulation.contacts(), again, build * 1e3, contacts / seconds, seconds / contacts * 1e6,
      static_cast<double>(simulation.events()) / contacts, (largest - before) / count / 1024,
      collisions.energy() / energy - 1,
      std::max(std::fabs(collisions.momentum().x - momentum.x), std::fabs(collisions.momentum().y - momentum.y)));
}

/// What it costs to ignore a pair, to take a body away, to add it again at the same place, and to attach it to another
/// one; in microseconds a call, after the first call of each kind.
void run_changes(int count, int vertices, double fraction, int changes) {
  Gas start = gas(count, vertices, fraction);
  Simulation simulation(start.scene);
  simulation.advance_to(0x1p-10);
  std::array<double, 4> seconds{};
  const auto timed = [&](std::size_t kind, int round, const auto& call) {
    const Stopwatch watch;
    call();
    if (round > 0) seconds[kind] += watch.seconds();
  };
  for (int k = 0; k <= changes; ++k) {
    const auto body = static_cast<BodyId>((2654435761u * static_cast<unsigned>(k)) % static_cast<unsigned>(count));
    Body again = simulation.scene().bodies[static_cast<std::size_t>(body)];
    if (again.name.find("removed") != std::string::npos) continue;
    const BodyId other = (body + 1) % count;
    if (simulation.scene().bodies[static_cast<std::size_t>(other)].name.find("removed") == std::string::npos)
      timed(0, k, [&] { simulation.ignore(body, other); });
    timed(1, k, [&] { simulation.remove_body(body); });
    again.name += " again";
    BodyId added = 0;
    timed(2, k, [&] { added = simulation.add_body(again); });
    // To a wall, which rests.
    timed(3, k, [&] { simulation.set_parent(added, count, again.motion); });
  }
  fmt::print("{:>7} {:>3} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f}\n", count, vertices, seconds[0] / changes * 1e6,
             seconds[1] / changes * 1e6, seconds[2] / changes * 1e6, seconds[3] / changes * 1e6);
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  CLI::App app("event-driven dynamics of polygons");
  std::vector<int> bodies{100, 1000, 10000};
  int vertices = 6;
  double fraction = 0.5;
  std::uint64_t contacts = 20000;
  app.add_option("--bodies", bodies, "how many bodies; several for several rows");
  app.add_option("--vertices", vertices, "of each body: 6 is a hexagon, more an even number for a star");
  app.add_option("--fraction", fraction, "of the box that bodies fill");
  app.add_option("--contacts", contacts, "how many contacts to follow");
  int changes = 0;
  app.add_option("--changes", changes, "time so many calls of each kind that changes which bodies there are, instead");
  CLI11_PARSE(app, argc, argv);
  if (changes > 0) {
    fmt::print("{:>7} {:>3} {:>9} {:>9} {:>9} {:>9}   us each\n", "bodies", "n", "ignore", "remove", "add", "attach");
    for (const int count : bodies) taut::bench::run_changes(count, vertices, fraction, changes);
    return 0;
  }
  fmt::print("{:>7} {:>3} {:>5} {:>8} {:>6} {:>9} {:>9} {:>9} {:>8} {:>9} {:>9} {:>9}\n", "bodies", "n", "area",
             "contacts", "again", "build ms", "per s", "us each", "events", "KiB/body", "energy", "momentum");
  for (const int count : bodies) taut::bench::run(count, vertices, fraction, contacts);
}
