#include "motion/pair_plan.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/hull.hpp"
#include "motion/motion_plan.hpp"

namespace taut {
namespace {

BodyMap map_body(const Polygon& polygon, int body) {
  BodyMap m;
  m.body = body;
  m.size = static_cast<std::uint32_t>(polygon.size());
  m.reversed = polygon_orientation(polygon) < 0;
  // The lexicographically smallest vertex is a strict corner of the hull.
  const auto smallest = std::min_element(polygon.begin(), polygon.end(), [](const Point& a, const Point& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  m.first = static_cast<std::uint32_t>(smallest - polygon.begin());
  return m;
}

/// Are all coordinates multiples of 2^-75? Then the distance of a vertex from an edge is at least 2^-150 / sqrt 8,
/// above any displacement (2^-159 at the tip of the sharpest spike).
bool on_coarse_lattice(const std::vector<Point>& polygon) {
  return std::all_of(polygon.begin(), polygon.end(), [](const Point& v) {
    return std::ldexp(std::floor(std::ldexp(v.x, 75)), -75) == v.x &&
           std::ldexp(std::floor(std::ldexp(v.y, 75)), -75) == v.y;
  });
}

}  // namespace

PairPlan plan_pair(const Scene& scene) {
  PairPlan plan;
  double largest = 0;
  for (const Body& body : scene.bodies) {
    for (const Point& v : body.polygon) largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  plan.exponent = -exponent;
  const double d0 = diameter_squared(scene.bodies[0].polygon), d1 = diameter_squared(scene.bodies[1].polygon);
  plan.extent = std::max(bounding_diagonal(scene.bodies[0].polygon), bounding_diagonal(scene.bodies[1].polygon));
  // The polygon with the larger diameter plays P (section 2.1 of the paper).
  const int p = d1 > d0 ? 1 : 0;
  for (int k = 0; k < 2; ++k) {
    const int index = k == 0 ? p : 1 - p;
    const Body& body = scene.bodies[static_cast<std::size_t>(index)];
    const auto side = static_cast<std::size_t>(k);
    const BodyMap m = plan.maps[side] = map_body(body.polygon, index);
    for (std::uint32_t i = 0; i < m.size; ++i) {
      const Point& v = body.polygon[static_cast<std::size_t>(m.vertex(i))];
      plan.polygons[side].push_back({std::ldexp(v.x, plan.exponent), std::ldexp(v.y, plan.exponent)});
    }
    for (const MotionPiece& piece : pieces_between(body.motion, scene.start, scene.end)) {
      plan.pieces[side].push_back(scaled(piece, plan.exponent));
    }
  }
  return plan;
}

PairGeometry displaced_pair(const PairPlan& plan, bool inwards) {
  PairGeometry g;
  g.points = displace(plan.polygons[0], inwards, displacement_unit, 1);
  g.np = static_cast<std::uint32_t>(g.points.size());
  const auto q = displace(plan.polygons[1], inwards, displacement_unit, 0x1234567);
  g.points.insert(g.points.end(), q.begin(), q.end());
  g.nq = static_cast<std::uint32_t>(q.size());
  g.fine_features = !on_coarse_lattice(plan.polygons[0]) || !on_coarse_lattice(plan.polygons[1]);
  return g;
}

}  // namespace taut
