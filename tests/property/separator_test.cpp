// Separators against oracles: no lattice curve has fewer edges than the lower bound, and every curve given is one.
#include "taut/separator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "support/effort.hpp"
#include "support/link_search.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"

namespace taut::testing {
namespace {

Polygon to_doubles(const std::vector<IntPoint>& polygon) {
  Polygon out;
  for (const IntPoint& v : polygon) out.push_back({static_cast<double>(v.x), static_cast<double>(v.y)});
  return out;
}

/// Counterclockwise; or nothing if it is not simple, or has three corners in a row on a line.
std::vector<IntPoint> simple_or_nothing(std::vector<IntPoint> points) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) area += cross({0, 0}, points[i], points[(i + 1) % points.size()]);
  if (area < 0) std::reverse(points.begin(), points.end());
  const auto side = [](std::int64_t x) { return (x > 0) - (x < 0); };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const IntPoint a = points[i], b = points[(i + 1) % points.size()], c = points[(i + 2) % points.size()];
    if (cross(a, b, c) == 0) return {};
    for (std::size_t j = i + 2; j < points.size(); ++j) {
      if (i == 0 && j + 1 == points.size()) continue;
      const IntPoint u = points[j], v = points[(j + 1) % points.size()];
      if (side(cross(a, b, u)) * side(cross(a, b, v)) <= 0 && side(cross(u, v, a)) * side(cross(u, v, b)) <= 0)
        return {};
    }
  }
  return points;
}

std::vector<IntPoint> scattered(Rng& rng, int n, int reach) {
  std::vector<IntPoint> points;
  for (int i = 0; i < n; ++i) points.push_back({rng.below(2 * reach + 1) - reach, rng.below(2 * reach + 1) - reach});
  return simple_or_nothing(points);
}

std::vector<IntPoint> shaken(Rng& rng, std::vector<IntPoint> points, IntPoint offset) {
  for (IntPoint& v : points) v = {v.x + offset.x + rng.below(3) - 1, v.y + offset.y + rng.below(3) - 1};
  return simple_or_nothing(points);
}

struct TinyPair {
  std::vector<IntPoint> p, q;
};

/// Scattered corners; a body in the pocket of another one; or two hooks in each other.
TinyPair tiny_pair(Rng& rng, int kind) {
  const std::vector<IntPoint> pocket{{-7, -7}, {7, -7},  {7, 7},  {2, 7},  {2, 4},  {5, 4},
                                     {5, -4},  {-5, -4}, {-5, 4}, {-2, 4}, {-2, 7}, {-7, 7}};
  const std::vector<IntPoint> hook{{-7, -7}, {4, -7}, {4, 1}, {1, 1}, {1, -4}, {-4, -4}, {-4, 7}, {-7, 7}};
  std::vector<IntPoint> other;
  switch (kind) {
    case 0:
      return {scattered(rng, 5 + rng.below(7), 8), scattered(rng, 3 + rng.below(6), 7)};
    case 1:
      return {shaken(rng, pocket, {0, 0}),
              shaken(rng, {{-2, -2}, {2, -2}, {1, 2}}, {rng.below(5) - 2, rng.below(3) - 1})};
    default:
      for (const IntPoint& v : hook) other.push_back({-v.x, -v.y});
      return {shaken(rng, hook, {0, 0}), shaken(rng, other, {0, rng.below(3) - 1})};
  }
}

TEST(SeparatorOracle, NoLatticeCurveHasFewerEdges) {
  constexpr int extent = 9;
  int compared = 0, equal = 0, by_links[16] = {};
  for (std::uint64_t seed = 0; compared < 3 * static_cast<int>(effort(85)); ++seed) {
    Rng rng(seed);
    const int kind = compared / static_cast<int>(effort(85));
    const auto [p, q] = tiny_pair(rng, kind);
    if (p.empty() || q.empty()) continue;
    const Separator found = separator(to_doubles(p), to_doubles(q));
    if (found.overlap) continue;
    // Mostly those that are intertwined.
    if (found.minimum_link.upper == 1 && seed % 64 != 0) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MinimumLinkSeparator& m = found.minimum_link;
    EXPECT_LE(m.lower, m.upper);
    EXPECT_TRUE(is_separator(m.vertices, m.closed, to_doubles(p), to_doubles(q)));
    const int lattice = fewest_lattice_links(p, q, extent);
    ASSERT_GT(lattice, 0);
    EXPECT_GE(lattice, m.lower);
    ++compared;
    equal += lattice == m.lower;
    ++by_links[std::min(m.lower, 15)];
  }
  std::cout << compared << " pairs, the lattice attains the lower bound of " << equal << ";";
  for (int k = 1; k < 16; ++k) std::cout << ' ' << by_links[k];
  std::cout << '\n';
  EXPECT_GT(equal, compared / 2);
  EXPECT_GT(by_links[2], compared / 10);
  EXPECT_GT(by_links[3], compared / 10);
  EXPECT_GT(by_links[4] + by_links[5], compared / 40);
}

TEST(SeparatorOracle, CurvesSeparateAndBoundsAreTight) {
  int closed = 0, exact = 0, all = 0;
  for (std::uint64_t seed = 0; seed < effort(20); ++seed) {
    for (const Family family : all_families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      Rng rng(seed * 8 + static_cast<std::uint64_t>(family));
      const PolygonPair pair = random_pair(rng, family);
      const Separator found = separator(pair.p, pair.q);
      ASSERT_FALSE(found.overlap);
      const MinimumLinkSeparator& m = found.minimum_link;
      EXPECT_LE(m.lower, m.upper);
      EXPECT_LE(m.upper, m.lower + 1);
      EXPECT_TRUE(is_separator(m.vertices, m.closed, pair.p, pair.q));
      EXPECT_EQ(m.upper, static_cast<int>(m.vertices.size()) - (m.closed ? 0 : 1));
      // Lemma 2.4: an edge of a separator crosses a geodesic cycle at most twice.
      for (const int edges : found.moving.bichromatic_edges) EXPECT_LE(edges, 2 * m.lower);
      ++all;
      closed += m.closed;
      exact += m.lower == m.upper;
    }
  }
  std::cout << all << " pairs, " << closed << " closed curves, " << exact << " exact\n";
  EXPECT_GT(closed, all / 20);
  EXPECT_GT(exact, all * 9 / 10);
}

/// Exchanging, turning and scaling change nothing that matters.
TEST(SeparatorOracle, BoundsKeepUnderSymmetries) {
  for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
    for (const Family family : {Family::intertwined, Family::nested, Family::spirals, Family::combs}) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      Rng rng(900 + seed * 8 + static_cast<std::uint64_t>(family));
      const PolygonPair pair = random_pair(rng, family);
      const MinimumLinkSeparator plain = separator(pair.p, pair.q).minimum_link;
      const auto turned = [](Polygon polygon) {
        for (Point& v : polygon) v = {-4 * v.y, 4 * v.x};
        std::reverse(polygon.begin(), polygon.end());
        return polygon;
      };
      const auto mirrored = [](Polygon polygon) {
        for (Point& v : polygon) v.x = -v.x;
        return polygon;
      };
      for (const MinimumLinkSeparator& other :
           {separator(pair.q, pair.p).minimum_link, separator(turned(pair.p), turned(pair.q)).minimum_link,
            separator(mirrored(pair.p), mirrored(pair.q)).minimum_link}) {
        EXPECT_LE(other.lower, plain.upper);
        EXPECT_LE(plain.lower, other.upper);
      }
    }
  }
}

}  // namespace
}  // namespace taut::testing
