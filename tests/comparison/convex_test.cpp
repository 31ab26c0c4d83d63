// Separating lines of convex bodies: they separate, exactly, wherever they are said to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparison/convex_separation.hpp"
#include "geometry/predicates.hpp"
#include "runs.hpp"

namespace taut::paper {
namespace {

TEST(ComparisonConvex, HullsContainThePolygonAndHalve) {
  const Scene scene = convex_turning(400, 3);
  const MovingBodies bodies(scene);
  const std::vector<Point> at = bodies.positions(scene.start);
  const Polygon ring(at.begin(), at.begin() + bodies.first(1));
  const auto levels = outer_hierarchy(ring);
  EXPECT_GT(levels.size(), 4u);
  EXPECT_LT(levels.front().ring.size(), 9u);
  EXPECT_EQ(ring.size(), levels.back().ring.size());
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    EXPECT_LT(levels[k].ring.size(), levels[k + 1].ring.size());
    EXPECT_GT(levels[k].excess, levels[k + 1].excess);
    // The lines are those of sides, which are exact; and a coarser polygon has fewer of them.
    for (const int side : levels[k].side) {
      const auto& finer = levels[k + 1].side;
      EXPECT_TRUE(std::find(finer.begin(), finer.end(), side) != finer.end());
    }
    for (const Point& p : levels[k].ring) EXPECT_LE(internal::side_of_ring(ring, p), 0);
  }
}

/// Between any two events, at several instants, one body is left of the line or on it, the other one is right of it.
TEST(ComparisonConvex, LinesSeparate) {
  std::uint64_t looked = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Scene scene = seed % 2 ? convex_turning(200, seed) : convex_passing(200, seed);
    const MovingBodies bodies(scene);
    ConvexSeparation separation(scene);
    do {
      const double next = std::min(separation.next_time(), scene.end);
      for (const double share : {0.25, 0.5, 0.75}) {
        const double t = separation.time() + share * (next - separation.time());
        if (next - separation.time() < 1e-9) continue;
        const auto [from, to] = separation.line(t);
        const int other = 1 - separation.owner();
        for (int v = bodies.first(other); v < bodies.first(other + 1); ++v)
          ASSERT_LT(internal::orientation(from, to, bodies.at(v, t).position), 0) << seed << " at " << t;
        // Whether the line is one of a side: its owner's other vertices are left of it, but for rounding.
        const int own = separation.owner();
        for (int v = bodies.first(own); v < bodies.first(own + 1); ++v) {
          const Point p = bodies.at(v, t).position;
          if (p == from || p == to) continue;
          ASSERT_GT(internal::orientation(from, to, p), 0) << seed << " at " << t;
        }
        ++looked;
      }
    } while (separation.step());
  }
  EXPECT_GT(looked, 60u);
}

}  // namespace
}  // namespace taut::paper
