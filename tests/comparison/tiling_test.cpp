// Pseudo-triangulations of the common exterior: valid at the start and after every event, by checks from their
// definition; and what their certificates say, against overlaps found by looking at every two edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparison/kinetic_tiling.hpp"
#include "comparison/pointed_tiling.hpp"
#include "comparison/worlds.hpp"
#include "generators/generators.hpp"
#include "geometry/predicates.hpp"
#include "support/rng.hpp"

namespace taut::paper {
namespace {

/// Whether two of the bodies overlap: two edges cross, or a vertex lies within another body.
bool some_overlap(const MovingBodies& bodies, const std::vector<Point>& at) {
  const auto point = [&](int v) { return at[static_cast<std::size_t>(v)]; };
  const auto side = [&](int u, int v, int w) { return internal::orientation(point(u), point(v), point(w)); };
  for (int a = 0; a < bodies.bodies(); ++a) {
    Polygon ring(at.begin() + bodies.first(a), at.begin() + bodies.first(a + 1));
    for (int v = 0; v < bodies.vertices(); ++v) {
      if (bodies.body_of(v) == a) continue;
      if (internal::side_of_ring(ring, point(v)) >= 0) return true;
      const int w = bodies.next(v);
      for (int p = bodies.first(a); p < bodies.first(a + 1); ++p) {
        const int q = bodies.next(p);
        if (side(v, w, p) * side(v, w, q) < 0 && side(p, q, v) * side(p, q, w) < 0) return true;
      }
    }
  }
  return false;
}

int reflex_vertices(const MovingBodies& bodies, const std::vector<Point>& at) {
  int count = 0;
  for (int v = 0; v < bodies.vertices(); ++v) {
    const auto point = [&](int w) { return at[static_cast<std::size_t>(w)]; };
    count += internal::orientation(point(bodies.previous(v)), point(v), point(bodies.next(v))) < 0;
  }
  return count;
}

/// Follows the tiling to the end, and looks at it between every two events that are not too near to each other.
struct Followed {
  std::uint64_t events = 0, looked = 0;
  std::string fault;
};
Followed follow(const Scene& scene, bool crossings) {
  const MovingBodies bodies(scene);
  KineticTiling tiling(bodies, scene.start, scene.end);
  Followed out;
  const std::vector<Point> start = bodies.positions(scene.start);
  out.fault = find_fault(tiling.map(), bodies, start, true);
  EXPECT_EQ(3 * bodies.bodies() - 3 + reflex_vertices(bodies, start), tiling.map().free_edges());
  while (out.fault.empty() && tiling.step()) {
    const double next = std::min(tiling.next_time(), scene.end);
    if (next - tiling.time() < 1e-9) continue;
    const double between = (tiling.time() + next) / 2;
    out.fault = find_fault(tiling.map(), bodies, bodies.positions(between), crossings);
    ++out.looked;
  }
  out.events = tiling.events();
  return out;
}

Scene gas_scene(const char* family, int bodies, double fraction, std::uint64_t contacts) {
  return shrunk(*simulated_gas(gas_shape(family), bodies, fraction, contacts, true).record, 1e-6, 1);
}

TEST(ComparisonTiling, IsValidAfterEveryEventOfAGas) {
  for (const char* family : {"hexagons", "stars", "gears"}) {
    const Followed found = follow(gas_scene(family, 9, 0.5, 60), true);
    EXPECT_EQ("", found.fault) << family;
    EXPECT_GT(found.looked, found.events / 2) << family;
    EXPECT_GT(found.events, 100u) << family;
  }
}

TEST(ComparisonTiling, IsValidAfterEveryEventOfAPair) {
  gen::CombOptions combs;
  combs.teeth = 5;
  gen::DipOptions dips;
  dips.sides = 20;
  dips.dips = 2;
  gen::RotorOptions rotor;
  rotor.teeth = rotor.chain_edges = 8;
  gen::GearOptions gears;
  gears.turns = 0.2;
  const std::pair<const char*, Scene> families[] = {{"combs", gen::make_combs(combs)},
                                                    {"dips", gen::make_dips(dips)},
                                                    {"rotor", gen::make_rotor(rotor)},
                                                    {"gears", gen::make_gears(gears)}};
  for (const auto& [name, scene] : families) {
    const Followed found = follow(jittered(scene, 1e-7, 3), true);
    EXPECT_EQ("", found.fault) << name;
    EXPECT_GT(found.looked, 10u) << name;
  }
}

TEST(ComparisonTiling, FaultsAreNoticed) {
  const Scene scene = gas_scene("stars", 4, 0.4, 5);
  const MovingBodies bodies(scene);
  std::vector<Point> at = bodies.positions(scene.start);
  const KineticTiling tiling(bodies, scene.start, scene.end);
  ASSERT_EQ("", find_fault(tiling.map(), bodies, at, true));
  // A body elsewhere; and maps in which an edge went another way, of which few are tilings, too.
  for (int v = bodies.first(0); v < bodies.first(1); ++v) at[static_cast<std::size_t>(v)].x += 0.9;
  EXPECT_NE("", find_fault(tiling.map(), bodies, at, true));
  at = bodies.positions(scene.start);
  int wrong = 0;
  for (int h = 0; h < tiling.map().size(); ++h) {
    if (tiling.map().is_side(h)) continue;
    HalfEdges map = tiling.map();
    map.slide_this(h);
    wrong += !find_fault(map, bodies, at, true).empty();
  }
  EXPECT_GT(wrong, 3 * tiling.map().free_edges() / 2);
}

__extension__ using Wide = __int128;

/// Twice the area of a polygon whose vertices are whole multiples of 2^-30, in units of 2^-60: exact.
template <class Range>
Wide twice_area(const Range& ring) {
  const auto whole = [](double x) { return static_cast<Wide>(std::llround(std::ldexp(x, 30))); };
  Wide sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    sum += whole(a.x) * whole(b.y) - whole(a.y) * whole(b.x);
  }
  return sum;
}

/// The convex hull, counterclockwise.
Polygon hull_of(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), internal::lexicographically_less);
  Polygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Point& p : points) {
      while (hull.size() > base + 1 && internal::orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The faces have positive areas, whose sum is that of the convex hull without the bodies.
TEST(ComparisonTiling, FacesFillTheFreeSpace) {
  for (const char* family : {"hexagons", "stars", "gears"}) {
    const Scene scene = gas_scene(family, 9, 0.4, 20);
    const MovingBodies bodies(scene);
    KineticTiling tiling(bodies, scene.start, scene.end);
    while (tiling.step()) {
    }
    std::vector<Point> at = bodies.positions(scene.end);
    for (Point& p : at)
      p = {std::ldexp(std::round(std::ldexp(p.x, 30)), -30), std::ldexp(std::round(std::ldexp(p.y, 30)), -30)};
    Wide faces = 0, expected = twice_area(hull_of(at));
    for (int body = 0; body < bodies.bodies(); ++body)
      expected -= twice_area(Polygon(at.begin() + bodies.first(body), at.begin() + bodies.first(body + 1)));
    std::vector<bool> seen(static_cast<std::size_t>(tiling.map().size()));
    int infinite = 0;
    for (int start = 0; start < tiling.map().size(); ++start) {
      Polygon face;
      for (int h = start; !seen[static_cast<std::size_t>(h)]; h = tiling.map().next(h)) {
        seen[static_cast<std::size_t>(h)] = true;
        face.push_back(at[static_cast<std::size_t>(tiling.map().origin(h))]);
      }
      if (face.empty() || tiling.map().is_inside(start)) continue;
      const Wide area = twice_area(face);
      area > 0 ? void(faces += area) : void(++infinite);
    }
    EXPECT_EQ(1, infinite) << family;
    EXPECT_TRUE(faces == expected) << family;
  }
}

/// Bodies at random places that hold all certificates of a tiling do not overlap.
TEST(ComparisonTiling, CertificatesCertify) {
  testing::Rng rng(5);
  int held = 0, overlapped = 0;
  for (int round = 0; round < 400; ++round) {
    Scene scene = gas_scene(round % 2 ? "stars" : "hexagons", 4, 0.45, 1);
    scene.end = scene.start + 1;
    const double far = round % 4 < 2 ? 0.05 : 1;
    for (std::size_t k = 0; k < 4; ++k) {
      MotionPiece& piece = scene.bodies[k].motion.pieces[0];
      scene.bodies[k].motion.pieces = {piece};
      MotionPiece& only = scene.bodies[k].motion.pieces[0];
      only.until = INFINITY;
      only.x[1] = rng.real(-far, far);
      only.y[1] = rng.real(-far, far);
      std::get<AngleRotation>(only.rotation).angle[1] = rng.real(-far, far);
    }
    const MovingBodies bodies(scene);
    // Only for a moment, so that it is the tiling of the start.
    const KineticTiling tiling(bodies, scene.start, scene.start + 1e-9);
    const bool holds = tiling.holds(scene.end), overlap = some_overlap(bodies, bodies.positions(scene.end));
    EXPECT_FALSE(holds && overlap) << round;
    held += holds;
    overlapped += overlap;
  }
  EXPECT_GT(held, 20);
  EXPECT_GT(overlapped, 100);
}

}  // namespace
}  // namespace taut::paper
