#include "dynamics/gas.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "generators/shapes.hpp"

namespace taut::bench {

Polygon gas_polygon(int vertices) {
  Polygon ring;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices, radius = vertices > 6 && k % 2 ? 0.7 : 1;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

Gas gas(int bodies, int vertices, double fraction) {
  gen::Random random(7);
  Gas all;
  const Polygon ring = gas_polygon(vertices);
  const double pitch = std::sqrt(elastic::rigid_body(ring).mass / fraction);
  const int columns = static_cast<int>(std::ceil(std::sqrt(bodies)));
  all.side = pitch * columns;
  all.count = static_cast<std::size_t>(bodies);
  all.scene.end = 1000;
  for (int k = 0; k < bodies; ++k) {
    all.scene.bodies.push_back({"body " + std::to_string(k), ring, {}});
    all.bodies.push_back(elastic::rigid_body(ring));
    elastic::RigidBody& body = all.bodies.back();
    body.at = {pitch * (k % columns + 0.5), pitch * (k / columns + 0.5)};
    body.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
    body.spin = random.uniform(-1, 1);
  }
  const auto wall = [&](const char* name, double x, double y, double w, double h) {
    all.scene.bodies.push_back({name, {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, {}});
    all.bodies.emplace_back();
  };
  const double s = all.side;
  wall("bottom", -1, -1, s + 2, 1);
  wall("top", -1, s, s + 2, 1);
  wall("left", -1, 0, 1, s);
  wall("right", s, 0, 1, s);
  const elastic::Collisions motions(all.bodies, 0);
  for (int k = 0; k < bodies; ++k) all.scene.bodies[static_cast<std::size_t>(k)].motion = motions.motion(k);
  return all;
}

}  // namespace taut::bench
