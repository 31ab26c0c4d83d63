#include "figure_tools.hpp"

#include <cmath>
#include <stdexcept>

namespace taut::paper {

TilingDrawOptions panel_options() {
  TilingDrawOptions o;
  o.width = 440;
  o.legend = false;
  o.title.assign(1, ' ');
  return o;
}

Simulation at(const Scene& scene, double t) {
  Simulation simulation(scene);
  simulation.advance_to(t);
  return simulation;
}

const Point& position(const Tiling& tiling, int v) { return tiling.vertices[static_cast<std::size_t>(v)].position; }

int find_vertex(const Tiling& tiling, int body, int index) {
  for (std::size_t i = 0; i < tiling.vertices.size(); ++i) {
    if (tiling.vertices[i].vertex == VertexRef{body, index}) return static_cast<int>(i);
  }
  throw std::logic_error("no such vertex");
}

Point outwards(const Scene& scene, const Tiling& tiling, int v, double distance) {
  // Away from the body's middle, which is good enough for letters.
  const VertexRef& vertex = tiling.vertices[static_cast<std::size_t>(v)].vertex;
  const std::size_t n = scene.bodies[static_cast<std::size_t>(vertex.body)].polygon.size();
  const Point a = position(
      tiling, find_vertex(tiling, vertex.body, static_cast<int>((static_cast<std::size_t>(vertex.index) + n - 1) % n)));
  const Point b = position(
      tiling, find_vertex(tiling, vertex.body, static_cast<int>((static_cast<std::size_t>(vertex.index) + 1) % n)));
  const Point& p = tiling.vertices[static_cast<std::size_t>(v)].position;
  double dx = 2 * p.x - a.x - b.x, dy = 2 * p.y - a.y - b.y;
  const double turn = (p.x - a.x) * (b.y - p.y) - (p.y - a.y) * (b.x - p.x), length = std::hypot(dx, dy);
  const double side = turn > 0 ? 1 : -1;
  return {p.x + side * distance * dx / length, p.y + side * distance * dy / length};
}

}  // namespace taut::paper
