// The cells of a map: what they call free or covered is, and the room about a point is there.
#include "scene/free_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/effort.hpp"

namespace taut::testing {
namespace {

using internal::FreeCells;

/// The larger of the two coordinates' distances.
double away(const Point& p, const Point& q) { return std::max(std::fabs(p.x - q.x), std::fabs(p.y - q.y)); }

/// Of a point from a segment, by halving: the distance is convex along it.
double away(const Point& p, const Point& a, const Point& b) {
  const auto at = [&](double s) { return away(p, {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}); };
  double lo = 0, hi = 1;
  for (int i = 0; i < 60; ++i) {
    const double third = (hi - lo) / 3;
    (at(lo + third) < at(hi - third) ? hi : lo) = at(lo + third) < at(hi - third) ? hi - third : lo + third;
  }
  return std::min({at(lo), at(0), at(1)});
}

struct RandomMap {
  std::vector<Polygon> shapes;
  std::vector<internal::SharedRings> rings;

  explicit RandomMap(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    const int count = 1 + static_cast<int>(6 * share(random));
    for (int k = 0; k < count; ++k) {
      const Point middle{1.4 * share(random) - 0.7, 1.4 * share(random) - 0.7};
      const int corners = 3 + static_cast<int>(6 * share(random));
      const double flat = share(random) < 0.3 ? 0.01 : 1;
      Polygon shape;
      for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i / corners, far = 0.02 + 0.25 * share(random);
        shape.push_back({middle.x + far * std::cos(angle), middle.y + flat * far * std::sin(angle)});
      }
      Body body;
      body.name = "body " + std::to_string(k);
      body.polygon = shape;
      shapes.push_back(shape);
      rings.push_back(std::make_shared<const internal::RingSet>(body, k, 0));
    }
  }

  double away_from_boundaries(const Point& p) const {
    double least = INFINITY;
    for (const Polygon& shape : shapes) {
      for (std::size_t i = 0; i < shape.size(); ++i)
        least = std::min(least, away(p, shape[i], shape[(i + 1) % shape.size()]));
    }
    return least;
  }
  /// By the parity of edges above the point.
  bool covers(const Point& p) const {
    return std::any_of(shapes.begin(), shapes.end(), [&](const Polygon& shape) {
      bool inside = false;
      for (std::size_t i = 0; i < shape.size(); ++i) {
        const Point &a = shape[i], &b = shape[(i + 1) % shape.size()];
        if ((a.x > p.x) == (b.x > p.x)) continue;
        if (a.y + (p.x - a.x) / (b.x - a.x) * (b.y - a.y) > p.y) inside = !inside;
      }
      return inside;
    });
  }
};

TEST(FreeCells, HaveTheRoomThatTheySay) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  double known = 0, there = 0;
  for (int k = 0; k < static_cast<int>(effort(200)); ++k) {
    const RandomMap map(random);
    const FreeCells cells(map.rings);
    for (int i = 0; i < 300; ++i) {
      const double wide = i % 10 == 0 ? 40 : 2.2;
      const Point p{wide * (share(random) - 0.5), wide * (share(random) - 0.5)};
      const double distance = map.away_from_boundaries(p), room = cells.room(p.x, p.y);
      const bool covered = map.covers(p);
      ASSERT_LE(room, distance + 1e-12) << p.x << " " << p.y;
      ASSERT_TRUE(room == 0 || !covered) << p.x << " " << p.y;
      const FreeCells::Cell cell = cells.at(p.x, p.y);
      ASSERT_TRUE(cell != FreeCells::Cell::free || !covered) << p.x << " " << p.y;
      ASSERT_TRUE(cell != FreeCells::Cell::covered || covered) << p.x << " " << p.y;
      if (covered || wide > 3) continue;
      known += room;
      there += distance;
    }
  }
  EXPECT_GT(known, 0.8 * there);
}

}  // namespace
}  // namespace taut::testing
