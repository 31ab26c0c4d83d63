#include "coastline.hpp"

#include <cmath>

#include "generators/shapes.hpp"

namespace taut::bench {
namespace {

/// How far an edge's refinement may reach: two triangles on the edge with these angles at both its ends. A midpoint
/// moved to the left by the angle `turn` leaves both halves triangles inside the old ones when left' = left - turn and
/// right' = right + turn, as long as left + right + turn <= 90 degrees: edges that do not meet never will.
struct Wedge {
  double left, right;
};

constexpr double start_angle = 40 * gen::pi / 180;

/// Cuts edges into equal pieces no longer than `longest`.
Polygon cut_edges(const Polygon& outline, double longest) {
  Polygon out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i], b = outline[(i + 1) % outline.size()];
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / longest)));
    for (int k = 0; k < pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      out.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }
  }
  return out;
}

}  // namespace

Polygon coastline(const Polygon& outline, std::size_t vertices, std::uint64_t seed) {
  gen::Random random(seed);
  Polygon points = outline;
  std::vector<Wedge> wedges(points.size(), Wedge{start_angle, start_angle});
  while (points.size() < vertices) {
    const std::size_t n = points.size(), wanted = std::min(n, vertices - n);
    Polygon finer;
    std::vector<Wedge> finer_wedges;
    for (std::size_t i = 0; i < n; ++i) {
      finer.push_back(points[i]);
      finer_wedges.push_back(wedges[i]);
      // The last round refines only some edges, evenly spread.
      if ((i + 1) * wanted / n == i * wanted / n) continue;
      const Point a = points[i], b = points[(i + 1) % n];
      const Wedge w = wedges[i];
      const double turn = random.uniform(-0.45 * w.right, 0.45 * w.left);
      const double height = std::tan(turn) / 2;
      finer.push_back({(a.x + b.x) / 2 - height * (b.y - a.y), (a.y + b.y) / 2 + height * (b.x - a.x)});
      finer_wedges.back() = {w.left - turn, w.right + turn};
      finer_wedges.push_back(finer_wedges.back());
    }
    points.swap(finer);
    wedges.swap(finer_wedges);
  }
  return points;
}

Polygon island(std::size_t vertices, std::uint64_t seed) {
  Polygon hexagon;
  for (int k = 0; k < 6; ++k) hexagon.push_back(gen::polar(1, 0.2 + gen::pi * k / 3));
  return coastline(hexagon, vertices, seed);
}

Scene bay(std::size_t vertices) {
  const Polygon shore{{-2.5, -1}, {2.5, -1}, {2.5, 4}, {1.2, 4}, {1.2, 0}, {-1.2, 0}, {-1.2, 4}, {-2.5, 4}};
  const Polygon headland{{-0.9, 0.4}, {0.9, 0.4}, {0.9, 6}, {-0.9, 6}};
  // Roughness reaches 0.42 of a piece's length: less than half the gap.
  const double piece = 0.3;
  Scene scene;
  scene.end = 1;
  scene.bodies = {
      {"bay", coastline(cut_edges(shore, piece), vertices / 2, 1), {}},
      {"headland", coastline(cut_edges(headland, piece), vertices - vertices / 2, 2),
       Motion{{gen::translation({0, 0.01}, {0, 0.1})}}},
  };
  return scene;
}

}  // namespace taut::bench
