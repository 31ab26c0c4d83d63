#include "dynamics/gas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "generators/shapes.hpp"
#include "taut/error.hpp"

namespace taut::bench {

Polygon gas_polygon(int vertices) {
  Polygon ring;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices, radius = vertices > 6 && k % 2 ? 0.7 : 1;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

namespace {

/// Where bodies begin: the steps of a lattice, of which every other row may be half a step to the right.
struct Lattice {
  double across = 0, up = 0;
  bool staggered = false;
};

Lattice lattice_for(const Polygon& ring, double fraction) {
  const double area = elastic::rigid_body(ring).mass, square = std::sqrt(area / fraction);
  double radius = 0;
  for (const Point& p : ring) radius = std::max(radius, std::hypot(p.x, p.y));
  if (square > 2 * radius) return {square, square, false};
  const double step = std::sqrt(area / fraction * 2 / std::sqrt(3.0));
  if (step <= 2 * radius) throw InputError("fraction", "bodies that turn have no room to begin so densely");
  return {step, step * std::sqrt(0.75), true};
}

}  // namespace

Gas gas(int bodies, int vertices, double fraction) { return gas(bodies, gas_polygon(vertices), fraction); }

Gas gas(int bodies, const Polygon& ring, double fraction) {
  gen::Random random(7);
  Gas all;
  const Lattice lattice = lattice_for(ring, fraction);
  const int columns = static_cast<int>(std::ceil(std::sqrt(bodies)));
  const int rows = lattice.staggered ? (bodies + columns - 1) / columns : columns;
  all.side = lattice.across * (columns + (lattice.staggered ? 0.5 : 0));
  all.count = static_cast<std::size_t>(bodies);
  all.scene.end = 1000;
  for (int k = 0; k < bodies; ++k) {
    all.scene.bodies.push_back({"body " + std::to_string(k), ring, {}});
    all.bodies.push_back(elastic::rigid_body(ring));
    elastic::RigidBody& body = all.bodies.back();
    const double shift = lattice.staggered && k / columns % 2 ? 1 : 0.5;
    body.at = {lattice.across * (k % columns + shift), lattice.up * (k / columns + 0.5)};
    body.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
    body.spin = random.uniform(-1, 1);
  }
  const auto wall = [&](const char* name, double x, double y, double w, double h) {
    all.scene.bodies.push_back({name, {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, {}});
    all.bodies.emplace_back();
  };
  // Of staggered rows, the first and the last need as much room as all others between rows and sides.
  const double s = all.side, margin = lattice.staggered ? (lattice.across - lattice.up) / 2 : 0;
  const double low = -margin, high = lattice.up * rows + margin;
  wall("bottom", -1, low - 1, s + 2, 1);
  wall("top", -1, high, s + 2, 1);
  wall("left", -1, low, 1, high - low);
  wall("right", s, low, 1, high - low);
  const elastic::Collisions motions(all.bodies, 0);
  for (int k = 0; k < bodies; ++k) all.scene.bodies[static_cast<std::size_t>(k)].motion = motions.motion(k);
  return all;
}

}  // namespace taut::bench
