#include "comparison/worlds.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "dynamics/gas.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "taut/simulation.hpp"

namespace taut::paper {
namespace {

class Watch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Polygon gas_shape(const std::string& family) {
  if (family == "hexagons") return bench::gas_polygon(6);
  if (family == "stars") return bench::gas_polygon(16);
  Polygon ring;
  if (family != "gears") {
    const int sides = std::stoi(family);
    for (int k = 0; k < sides; ++k) ring.push_back(gen::polar(1, 2 * gen::pi * k / sides));
    return ring;
  }
  gen::GearOptions options;
  options.teeth_1 = 20;
  options.flank_points = 2;
  ring = gen::make_gears(options).bodies[0].polygon;
  double radius = 0;
  for (const Point& p : ring) radius = std::max(radius, std::hypot(p.x, p.y));
  for (Point& p : ring) p = {p.x / radius, p.y / radius};
  return ring;
}

SimulatedGas simulated_gas(const Polygon& shape, int bodies, double fraction, std::uint64_t contacts, bool record,
                           const std::function<void()>& at_contact) {
  const bench::Gas start = bench::gas(bodies, shape, fraction);
  elastic::Collisions collisions(start.bodies, 0x1p-44 * start.side);
  SimulationOptions options;
  options.record = record;
  Simulation simulation(start.scene, options);
  SimulatedGas out;
  double sum = 0, times = 0;
  const Watch watch;
  while (simulation.contacts() < contacts && simulation.advance_to(start.scene.end) == SimulationState::contact) {
    collisions.respond(simulation);
    sum += static_cast<double>(simulation.certificates());
    ++times;
    if (at_contact && simulation.contacts() % 64 == 0) at_contact();
  }
  out.seconds = watch.seconds();
  if (simulation.contacts() < contacts) throw std::runtime_error("a gas came to an end: " + simulation.reason());
  out.contacts = simulation.contacts();
  out.events = simulation.events();
  out.certificates_max = simulation.certificates_max();
  out.certificates_mean = sum / times;
  if (record) out.record = simulation.record().at(0);
  return out;
}

}  // namespace taut::paper
