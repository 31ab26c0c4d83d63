// Stars of five points on a table: they collide elastically, and no contact is missed or made up.
#include <iomanip>
#include <iostream>
#include <numbers>
#include <taut/taut.hpp>

#include "elastic.hpp"

namespace {

taut::Polygon star(double x, double y) {
  taut::Polygon ring;
  for (int k = 0; k < 10; ++k) {
    const double angle = k * std::numbers::pi / 5, radius = k % 2 ? 0.4 : 1;
    ring.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return ring;
}

taut::Polygon box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

}  // namespace

int main() {
  taut::Scene scene;
  scene.end = 1000;
  std::vector<elastic::RigidBody> bodies;
  for (int k = 0; k < 16; ++k) {
    scene.bodies.push_back({"star " + std::to_string(k), star(3 * (k % 4), 3 * (k / 4)), {}});
    bodies.push_back(elastic::rigid_body(scene.bodies.back().polygon));
    bodies.back().velocity = {0.1 * ((7 * k) % 11 - 5), 0.1 * ((5 * k) % 13 - 6)};
    bodies.back().spin = 0.1 * ((3 * k) % 7 - 3);
  }
  for (const taut::Polygon& wall : {box(-4, -4, 18, 1), box(-4, 12, 18, 1), box(-4, -3, 1, 15), box(13, -3, 1, 15)}) {
    scene.bodies.push_back({"wall " + std::to_string(scene.bodies.size()), wall, {}});
    bodies.emplace_back();
  }
  elastic::Collisions collisions(std::move(bodies), 0x1p-40);
  for (std::size_t k = 0; k < 16; ++k) scene.bodies[k].motion = collisions.motion(static_cast<int>(k));

  taut::SimulationOptions options;
  options.record = true;
  taut::Simulation simulation(scene, options);
  const double before = collisions.energy();
  while (simulation.contacts() < 200 && simulation.advance_to(scene.end) == taut::SimulationState::contact)
    collisions.respond(simulation);
  const taut::Scene record = simulation.record()[0];
  std::cout << (simulation.contacts() >= 200 ? "200 contacts" : simulation.reason())
            << ", energy kept to 1e-13: " << (std::abs(collisions.energy() / before - 1) < 1e-13 ? "yes" : "no")
            << ", all of it asked again: " << to_string(taut::check(record).outcome) << '\n';
}
