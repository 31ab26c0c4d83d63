// Convex hulls, orientation and diameter, against brute force.
#include "geometry/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace taut {
using namespace internal;
namespace {

std::vector<Point> random_points(std::mt19937& engine, int count, int range) {
  std::vector<Point> points(count);
  for (Point& p : points) p = {double(engine() % range), double(engine() % range)};
  return points;
}

double brute_diameter_squared(const std::vector<Point>& points) {
  double best = 0;
  for (const Point& a : points)
    for (const Point& b : points) best = std::max(best, (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  return best;
}

/// Of few points, and of so many that the hull decides.
void expect_diameter_squared(const std::vector<Point>& points, double expected) {
  ASSERT_EQ(diameter_squared(points), expected);
  std::vector<Point> many;
  for (int k = 0; k < 20; ++k) many.insert(many.end(), points.begin(), points.end());
  ASSERT_EQ(diameter_squared(many), expected);
}

/// All points are left of or on every hull edge, and the hull turns strictly left.
void expect_hull(const std::vector<Point>& points, const std::vector<int>& hull) {
  const std::size_t n = hull.size();
  for (std::size_t i = 0; i < n && n > 2; ++i) {
    const Point &a = points[hull[i]], &b = points[hull[(i + 1) % n]];
    ASSERT_GT(orientation(a, b, points[hull[(i + 2) % n]]), 0);
    for (const Point& p : points) ASSERT_GE(orientation(a, b, p), 0);
  }
  for (const Point& p : points) ASSERT_FALSE(lexicographically_less(p, points[hull[0]]));
}

TEST(ConvexHull, RandomAndGridPoints) {
  std::mt19937 engine(1);
  for (int round = 0; round < 3000; ++round) {
    const int range = round % 3 == 0 ? 3 : (round % 3 == 1 ? 7 : 100000);
    const std::vector<Point> points = random_points(engine, 1 + static_cast<int>(engine() % 30), range);
    const std::vector<int> hull = convex_hull(points);
    ASSERT_NO_FATAL_FAILURE(expect_hull(points, hull));
    ASSERT_NO_FATAL_FAILURE(expect_diameter_squared(points, brute_diameter_squared(points)));  // integers: exact
  }
}

TEST(ConvexHull, Degenerate) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_EQ(convex_hull({{1, 2}}), (std::vector<int>{0}));
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}}), (std::vector<int>{0}));
  EXPECT_EQ(convex_hull({{3, 3}, {1, 1}, {2, 2}, {0, 0}}), (std::vector<int>{3, 0}));
  EXPECT_EQ(convex_hull({{0, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}), (std::vector<int>{0, 1, 2, 4}));
}

TEST(ConvexHull, NearlyCollinearPointsAreDecidedExactly) {
  const double up = std::nextafter(0.3, 1.0);
  EXPECT_EQ(convex_hull({{0.1, 0.1}, {0.3, up}, {0.7, 0.7}}), (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(convex_hull({{0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}}), (std::vector<int>{0, 2}));
}

TEST(PolygonOrientation, BothWaysAndWithCollinearVertices) {
  EXPECT_EQ(polygon_orientation({{0, 0}, {1, 0}, {0, 1}}), 1);
  EXPECT_EQ(polygon_orientation({{0, 1}, {1, 0}, {0, 0}}), -1);
  EXPECT_EQ(polygon_orientation({{0, 2}, {0, 1}, {0, 0}, {2, 0}, {2, 2}, {1, 2}}), 1);
  EXPECT_EQ(polygon_orientation({{5, 1}, {0, 0}, {5, -1}, {1, 0}}), 1);
}

TEST(PolygonOrientation, AgreesWithTheAreaOfRandomStars) {
  std::mt19937 engine(2);
  for (int round = 0; round < 500; ++round) {
    const int n = 3 + static_cast<int>(engine() % 40);
    Polygon star(n);
    for (int i = 0; i < n; ++i) {
      const double r = 100 + double(engine() % 1000), angle = 6.283185307179586 * i / n;
      star[i] = {std::floor(r * std::cos(angle)), std::floor(r * std::sin(angle))};
    }
    double area = 0;
    for (int i = 0; i < n; ++i) area += star[i].x * star[(i + 1) % n].y - star[i].y * star[(i + 1) % n].x;
    ASSERT_EQ(polygon_orientation(star), area > 0 ? 1 : -1);
    std::reverse(star.begin(), star.end());
    ASSERT_EQ(polygon_orientation(star), area > 0 ? -1 : 1);
  }
}

TEST(Diameter, ParallelEdgesAndDegenerateInput) {
  expect_diameter_squared({}, 0);
  expect_diameter_squared({{3, 4}}, 0);
  expect_diameter_squared({{0, 0}, {3, 4}, {0, 0}}, 25);
  expect_diameter_squared({{0, 0}, {4, 0}, {4, 1}, {0, 1}}, 17);
  expect_diameter_squared({{0, 0}, {2, 0}, {5, 1}, {3, 1}}, 26);
  for (int n = 3; n < 60; ++n) {
    std::vector<Point> ring(n);
    for (int i = 0; i < n; ++i)
      ring[i] = {std::cos(0.1 + 6.283185307179586 * i / n), std::sin(0.1 + 6.283185307179586 * i / n)};
    EXPECT_DOUBLE_EQ(diameter_squared(ring), brute_diameter_squared(ring));
  }
}

}  // namespace
}  // namespace taut
