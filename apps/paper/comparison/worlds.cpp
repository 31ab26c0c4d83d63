#include "comparison/worlds.hpp"

#include <chrono>
#include <cmath>
#include <stdexcept>

#include "dynamics/gas.hpp"
#include "generators/generators.hpp"
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
  if (family != "gears") throw std::invalid_argument("no such shape: " + family);
  gen::GearOptions options;
  options.teeth_1 = 20;
  options.flank_points = 2;
  Polygon ring = gen::make_gears(options).bodies[0].polygon;
  double radius = 0;
  for (const Point& p : ring) radius = std::max(radius, std::hypot(p.x, p.y));
  for (Point& p : ring) p = {p.x / radius, p.y / radius};
  return ring;
}

RecordedGas recorded_gas(const Polygon& shape, int bodies, double fraction, std::uint64_t contacts) {
  const bench::Gas start = bench::gas(bodies, shape, fraction);
  RecordedGas out;
  elastic::Collisions collisions(start.bodies, 0x1p-44 * start.side);
  SimulationOptions options;
  options.record = true;
  Simulation simulation(start.scene, options);
  out.certificates_start = simulation.certificates();
  const Watch watch;
  while (simulation.contacts() < contacts && simulation.advance_to(start.scene.end) == SimulationState::contact)
    collisions.respond(simulation);
  out.seconds = watch.seconds();
  if (simulation.contacts() < contacts) throw std::runtime_error("a gas came to an end: " + simulation.reason());
  out.contacts = simulation.contacts();
  out.events = simulation.events();
  out.certificates_max = simulation.certificates_max();
  out.scene = simulation.record().at(0);
  return out;
}

}  // namespace taut::paper
