#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::gen {

Scene make_dips(const DipOptions& o) {
  require_range("--sides", o.sides, 3, 10000000);
  require_range("--dips", o.dips, 1, max_degree / 2);
  const Polygon cup{{-2.5, -1}, {2.5, -1}, {2.5, 4}, {1.2, 4}, {1.2, 0}, {-1.2, 0}, {-1.2, 4}, {-2.5, 4}};
  Polygon disc;
  // Turned a little, so that no side is parallel to the cup's.
  for (int i = 0; i < o.sides; ++i) disc.push_back(polar(1, 0.1 + 2 * pi * i / o.sides));
  // The Chebyshev polynomial of degree 2k reaches -1 k times, and 1 between: the paper's c prod (t - i)^2, evened out.
  const double lowest = o.hit ? 0.9 : 1.15, highest = 6;
  const double amplitude = (highest - lowest) / 2;
  Scene scene;
  scene.start = -1;
  scene.end = 1;
  scene.bodies = {
      {"cup", cup, {}},
      {"disc", disc, Motion{{translation({0, 0.05}, chebyshev(2 * o.dips, amplitude, lowest + amplitude))}}}};
  return scene;
}

}  // namespace taut::gen
