#include <vector>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::gen {

namespace {

/// The bit falls in steps towards the tip at x = 0: heights from left to right, and where each step ends.
struct Bit {
  std::vector<double> ends, heights;
};

Bit cut_bit(int steps, Random& random) {
  Bit bit;
  double x = 0, height = 0.5;
  for (int i = 0; i < steps; ++i) {
    bit.ends.insert(bit.ends.begin(), x);
    bit.heights.insert(bit.heights.begin(), height);
    x -= random.uniform(0.5, 1.5);
    height += random.uniform(0.15, 0.45);
  }
  bit.ends.insert(bit.ends.begin(), x);  // the bit's beginning
  return bit;
}

/// The staircase from the right end to the left one, moved by `dx`, `dy`.
void append_stairs(Polygon& polygon, const Bit& bit, double dx, double dy) {
  for (std::size_t i = bit.heights.size(); i-- > 0;) {
    polygon.push_back({bit.ends[i + 1] + dx, bit.heights[i] + dy});
    polygon.push_back({bit.ends[i] + dx, bit.heights[i] + dy});
  }
}

}  // namespace

Scene make_lock(const LockOptions& o) {
  require_range("--steps", o.steps, 1, 10000000);
  require_range("--clearance", o.clearance, 1e-6, 0.07);
  Random random(o.seed);
  const Bit bit = cut_bit(o.steps, random);
  const double left = bit.ends.front(), top = bit.heights.front();
  Polygon key{{left - 2, -1}, {left, -1}, {left, 0}, {0, 0}};
  append_stairs(key, bit, 0, 0);
  key.push_back({left, top + 1});
  key.push_back({left - 2, top + 1});

  // The keyway is the bit's outline, moved right and up by the clearance: since the bit falls to the right, it passes
  // with that clearance on its whole way in. The wrong keyway is too low in the middle.
  Bit keyway = bit;
  if (o.hit) keyway.heights[keyway.heights.size() / 2] -= 0.12 + o.clearance;
  const double c = o.clearance;
  Polygon lock{{left + c, -c - 3}, {4, -c - 3}, {4, top + 3}, {left + c, top + 3}};
  Polygon stairs;
  append_stairs(stairs, keyway, c, c);
  lock.insert(lock.end(), stairs.rbegin(), stairs.rend());
  lock.push_back({c, -c});
  lock.push_back({left + c, -c});

  // In from the left within time 1: x = -way (1 - t)^2 (1 + 2 t), at rest at both ends; a little unsteady in y.
  const double way = -left + 1;
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"lock", lock, {}},
                  {"key", key, Motion{{translation({-way, 0, 3 * way, -2 * way}, {0, 2 * c, -6 * c, 4 * c})}}}};
  return scene;
}

}  // namespace taut::gen
