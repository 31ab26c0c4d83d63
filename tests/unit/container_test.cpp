// The container around a hole: a simple polygon whose cavity is the hole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/container.hpp"
#include "geometry/displacement.hpp"
#include "support/random_polygons.hpp"
#include "support/rng.hpp"

namespace taut {
using namespace internal;
namespace {

using Ring = std::vector<DisplacedPoint>;

/// As a hole of a body, displaced: clockwise.
Ring hole_of(std::vector<Point> polygon, Offset offset, std::uint64_t seed) {
  double largest = 0;
  for (const Point& p : polygon) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  for (Point& p : polygon) p = {p.x / largest / 2, p.y / largest / 2};
  const SharedPolygon displaced = displaced_polygon(polygon, opposite(offset), seed);
  EXPECT_FALSE(displaced->fault);
  return {displaced->points.rbegin(), displaced->points.rend()};
}

bool edges_meet(const DisplacedPoint& a, const DisplacedPoint& b, const DisplacedPoint& c, const DisplacedPoint& d) {
  return orientation(a, b, c) != orientation(a, b, d) && orientation(c, d, a) != orientation(c, d, b);
}

bool same_point(const DisplacedPoint& a, const DisplacedPoint& b) {
  return a.x == b.x && a.y == b.y && a.dx == b.dx && a.dy == b.dy;
}

/// Exactly: no two edges meet but neighbours, and its signed area is positive about its first vertex, which is on the
/// hull.
void expect_simple(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_FALSE(same_point(ring[i], ring[(i + 1) % n]));
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;
      EXPECT_FALSE(edges_meet(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) << i << " and " << j;
    }
  }
  for (std::size_t i = 1; i < n; ++i)
    EXPECT_TRUE(ring[0].x < ring[i].x || (ring[0].x == ring[i].x && ring[0].y < ring[i].y));
  EXPECT_GT(orientation(ring[n - 1], ring[0], ring[1]), 0);
}

void expect_laws(const Ring& hole) {
  const std::optional<Container> container = container_around(hole);
  ASSERT_TRUE(container);
  const Ring& ring = container->polygon->points;
  ASSERT_EQ(ring.size(), hole.size() + 7);
  expect_simple(ring);
  // Every vertex and every edge of the hole is there, the mouth's vertex twice.
  std::multiset<std::uint32_t> vertices, edges;
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    const auto vertex = container->vertex(k), edge = container->edge(k);
    if (vertex) {
      vertices.insert(*vertex);
      const DisplacedPoint &here = ring[k], &there = hole[*vertex];
      EXPECT_EQ(here.x, there.x);
      EXPECT_EQ(here.y, there.y);
      // The mouth's other side is off by a small part of a displacement.
      EXPECT_LE(std::fabs(here.dx - there.dx), 0x1p-150);
      EXPECT_TRUE(same_point(here, there) || *vertex == container->mouth);
    } else {
      EXPECT_LE(std::max(std::fabs(ring[k].x), std::fabs(ring[k].y)), 1);
    }
    if (!edge) continue;
    edges.insert(*edge);
    EXPECT_EQ(ring[(k + 1) % ring.size()].x, hole[(*edge + 1) % hole.size()].x);
  }
  for (std::uint32_t k = 0; k < hole.size(); ++k) {
    EXPECT_EQ(vertices.count(k), k == container->mouth ? 2u : 1u);
    EXPECT_EQ(edges.count(k), 1u);
  }
}

TEST(Container, IsASimplePolygonAroundEveryHole) {
  testing::Rng rng(5);
  for (int round = 0; round < 60; ++round) {
    for (const testing::Family family : testing::all_families) {
      SCOPED_TRACE(std::string(to_string(family)) + " " + std::to_string(round));
      const testing::PolygonPair pair = testing::random_pair(rng, family, round % 3 == 0);
      for (const Polygon& polygon : {pair.p, pair.q})
        expect_laws(hole_of(polygon, round % 2 == 0 ? Offset::inward : Offset::outward, rng.next()));
    }
  }
}

TEST(Container, TakesRegularShapes) {
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Polygon beaded{{0, 0}, {1, 0}, {1, 0.25}, {1, 0.5}, {1, 0.75}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}};
  const Polygon diamond{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  const Polygon needles{{0, -1}, {0x1p-20, 0},        {1, 0x1p-20}, {0x1p-20, 0x1p-19},
                        {0, 1},  {-0x1p-20, 0x1p-19}, {-1, 0},      {-0x1p-20, 0}};
  for (const Polygon& polygon : {square, beaded, diamond, needles}) {
    for (const Offset offset : {Offset::outward, Offset::inward}) {
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(std::to_string(polygon.size()) + " vertices, " +
                     (offset == Offset::inward ? "inwards" : "outwards"));
        expect_laws(hole_of(polygon, offset, seed));
      }
    }
  }
}

}  // namespace
}  // namespace taut
