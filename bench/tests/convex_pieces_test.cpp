// The pieces are convex, of few vertices, and cover the polygon once.
#include "peers/convex_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coastline.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "geometry/predicates.hpp"

namespace taut::bench {
using namespace internal;
namespace {

double area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += (a.x - polygon[0].x) * (b.y - polygon[0].y) - (a.y - polygon[0].y) * (b.x - polygon[0].x);
  }
  return sum / 2;
}

/// By the crossings of a ray to the right.
bool inside(const Polygon& polygon, const Point& p) {
  bool in = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a.y > b.y) std::swap(a, b);
    if (a.y <= p.y && p.y < b.y && orientation(a, b, p) > 0) in = !in;
  }
  return in;
}

void expect_convex(const Polygon& piece) {
  const std::size_t n = piece.size();
  ASSERT_GE(n, 3u);
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = piece[i], &b = piece[(i + 1) % n];
    for (std::size_t k = 2; k < n; ++k) ASSERT_GT(orientation(a, b, piece[(i + k) % n]), 0);
  }
}

void expect_cover(const Polygon& polygon, const std::vector<Polygon>& pieces) {
  double sum = 0;
  for (const Polygon& piece : pieces) {
    ASSERT_NO_FATAL_FAILURE(expect_convex(piece));
    for (const Point& p : piece) ASSERT_NE(std::find(polygon.begin(), polygon.end(), p), polygon.end());
    sum += area(piece);
  }
  EXPECT_NEAR(sum, std::fabs(area(polygon)), 1e-9 * std::fabs(area(polygon)));
  double size = 0;
  for (const Point& p : polygon) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  gen::Random random(7);
  for (int k = 0; k < 300; ++k) {
    const Point p{random.uniform(-size, size), random.uniform(-size, size)};
    const auto count = std::count_if(pieces.begin(), pieces.end(), [&p](const Polygon& q) { return inside(q, p); });
    ASSERT_EQ(count, inside(polygon, p) ? 1 : 0) << p.x << ' ' << p.y;
  }
}

void expect_cut(const Polygon& polygon) {
  std::vector<Polygon> triangles;
  for (const Triangle& t : triangulate(polygon)) triangles.push_back({polygon[t[0]], polygon[t[1]], polygon[t[2]]});
  ASSERT_NO_FATAL_FAILURE(expect_cover(polygon, triangles));
  const std::vector<Polygon> pieces = convex_pieces(polygon, 8);
  for (const Polygon& piece : pieces) ASSERT_LE(piece.size(), 8u);
  ASSERT_NO_FATAL_FAILURE(expect_cover(polygon, pieces));
  EXPECT_LE(pieces.size(), triangles.size());
}

Polygon reversed(Polygon polygon) {
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

TEST(ConvexPieces, Generated) {
  gen::GearOptions gears;
  gen::CombOptions combs;
  gen::SpiralOptions spiral;
  gen::DipOptions dips;
  for (const Scene& scene : {gen::make_gears(gears), gen::make_combs(combs), gen::make_spiral(spiral),
                             gen::make_dips(dips), bay(400), bay(1000)}) {
    for (const Body& body : scene.bodies) {
      SCOPED_TRACE(body.name);
      ASSERT_NO_FATAL_FAILURE(expect_cut(body.polygon));
      ASSERT_NO_FATAL_FAILURE(expect_cut(reversed(body.polygon)));
    }
  }
}

TEST(ConvexPieces, Coastlines) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) ASSERT_NO_FATAL_FAILURE(expect_cut(island(20 + 30 * seed, seed)));
}

TEST(ConvexPieces, TheShortestDiagonalIsBlocked) {
  // The spike's tip (1, -1) lies in the triangle that the shortest diagonal, from the first vertex to the third, cuts
  // off.
  expect_cut({{0.5, 0}, {1, -3}, {1.5, 0}, {2.5, 9}, {1, -1}, {-0.5, 9}});
}

TEST(ConvexPieces, VerticesInLine) {
  // A plus of unit squares with every grid point on its boundary, so that diagonals run through vertices.
  expect_cut({{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}});
  expect_cut({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
  // A triangle whose smallest vertex has its neighbours in line with what follows.
  expect_cut({{0, 0}, {2, 2}, {1, 1.5}, {0.5, 1}, {0, 0.5}});
}

TEST(ConvexPieces, JoinedAsFarAsAllowed) {
  Polygon octagon, disc;
  for (int k = 0; k < 8; ++k) octagon.push_back(gen::polar(1, gen::pi * k / 4));
  for (int k = 0; k < 200; ++k) disc.push_back(gen::polar(1, gen::pi * k / 100));
  EXPECT_EQ(convex_pieces(octagon, 8).size(), 1u);
  EXPECT_EQ(convex_pieces(octagon, 3).size(), 6u);
  EXPECT_EQ(convex_pieces({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 8).size(), 2u);
  // 198 triangles; pieces of at most 8 vertices take up at most 6 of them.
  EXPECT_LE(convex_pieces(disc, 8).size(), 66u);
}

TEST(ConvexPieces, RefusesWhatIsNoPolygon) {
  EXPECT_THROW(triangulate({{0, 0}, {1, 1}, {2, 2}}), std::invalid_argument);
}

}  // namespace
}  // namespace taut::bench
