// validate_polygon: the sweep against brute force, every kind of error, a million vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "geometry/boundary_sweep.hpp"
#include "geometry/predicates.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut {
using namespace internal;
namespace {

constexpr double pi = 3.14159265358979323846;

std::string error_of(const Polygon& polygon) {
  try {
    validate_polygon(polygon, "P");
  } catch (const InputError& e) {
    EXPECT_EQ(e.place(), "P");
    EXPECT_FALSE(e.hint().empty());
    return e.what();
  }
  return "";
}

// Brute force, on integers and independent of the code under test: every pair of edges may share at most the vertex
// that neighbours share.

std::int64_t cross(const Point& a, const Point& b, const Point& c) {
  const auto i = [](double x) { return static_cast<std::int64_t>(x); };
  return (i(b.x) - i(a.x)) * (i(c.y) - i(a.y)) - (i(b.y) - i(a.y)) * (i(c.x) - i(a.x));
}

bool on_segment(const Point& a, const Point& b, const Point& p) {
  return cross(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b)) return true;
  return (cross(a, b, c) > 0) != (cross(a, b, d) > 0) && (cross(c, d, a) > 0) != (cross(c, d, b) > 0);
}

bool brute_simple(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return false;
  const auto at = [&](std::size_t i) { return polygon[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (on_segment(at(i), at(i + 1), at(i + 2)) || on_segment(at(i + 1), at(i + 2), at(i))) return false;
    if (at(i) == at(i + 1)) return false;
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) && segments_meet(at(i), at(i + 1), at(j), at(j + 1))) return false;
  }
  return true;
}

/// What the sweep reports must be true.
void expect_true_report(const Polygon& polygon, const SelfMeeting& m) {
  const int n = static_cast<int>(polygon.size());
  ASSERT_LT(m.first, m.second);
  const Point &a = polygon[m.first], &b = polygon[(m.first + 1) % n], &c = polygon[m.second],
              &d = polygon[(m.second + 1) % n];
  ASSERT_TRUE(segments_meet(a, b, c, d));
  const bool neighbours = m.second - m.first == 1 || m.second - m.first == n - 1;
  ASSERT_EQ(neighbours, m.kind == Meeting::fold_back);
  const bool line = cross(a, b, c) == 0 && cross(a, b, d) == 0;
  ASSERT_EQ(line, m.kind == Meeting::overlap || m.kind == Meeting::fold_back);
  if (line) {
    ASSERT_NE(m.from, m.to);
    for (const Point& p : {m.from, m.to}) ASSERT_TRUE(on_segment(a, b, p) && on_segment(c, d, p));
  }
  if (m.kind == Meeting::touch) {
    const Point& v = polygon[m.vertex];
    ASSERT_TRUE(on_segment(a, b, v) && on_segment(c, d, v));
  }
}

std::vector<int> sorted(const Polygon& polygon) {
  std::vector<int> order(polygon.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return lexicographically_less(polygon[a], polygon[b]); });
  return order;
}

void compare(const Polygon& polygon, int& simple) {
  const bool want = brute_simple(polygon);
  const std::string error = error_of(polygon);
  ASSERT_EQ(error.empty(), want) << error;
  simple += want;
  const std::vector<int> order = sorted(polygon);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (polygon[order[i - 1]] == polygon[order[i]]) return;  // repeated vertices: no sweep
  const std::optional<SelfMeeting> meeting = find_self_meeting(polygon, order);
  ASSERT_EQ(meeting.has_value(), !want);
  if (meeting) {
    ASSERT_NO_FATAL_FAILURE(expect_true_report(polygon, *meeting));
  }
}

Polygon random_grid_polygon(std::mt19937& engine, int n, int range) {
  Polygon polygon(n);
  for (Point& p : polygon) p = {double(engine() % range), double(engine() % range)};
  return polygon;
}

TEST(ValidatePolygon, AgreesWithBruteForceOnSmallGrids) {
  std::mt19937 engine(1);
  int simple = 0, rounds = 60000;
  for (int round = 0; round < rounds; ++round) {
    const int n = 3 + static_cast<int>(engine() % 8);
    ASSERT_NO_FATAL_FAILURE(compare(random_grid_polygon(engine, n, 2 + static_cast<int>(engine() % 6)), simple));
  }
  EXPECT_GT(simple, rounds / 50);
}

/// Random insertions that keep a grid polygon simple: larger polygons, full of collinear and touching-almost parts.
Polygon grown_grid_polygon(std::mt19937& engine, int size, int range) {
  Polygon polygon;
  while (polygon.size() < 3 || !brute_simple(polygon)) polygon = random_grid_polygon(engine, 3, range);
  for (int tries = 0; tries < 20 * size && static_cast<int>(polygon.size()) < size; ++tries) {
    Polygon longer = polygon;
    longer.insert(longer.begin() + static_cast<long>(engine() % polygon.size()),
                  random_grid_polygon(engine, 1, range)[0]);
    if (brute_simple(longer)) polygon = longer;
  }
  return polygon;
}

TEST(ValidatePolygon, AgreesWithBruteForceOnGrownPolygonsAndTheirNeighbours) {
  std::mt19937 engine(2);
  int simple = 0, rounds = 0;
  for (int seed = 0; seed < 250; ++seed) {
    const Polygon polygon = grown_grid_polygon(engine, 5 + seed % 26, 7);
    ASSERT_EQ(error_of(polygon), "");
    Polygon reversed(polygon.rbegin(), polygon.rend());
    ASSERT_EQ(error_of(reversed), "");
    for (int k = 0; k < 40; ++k, ++rounds) {  // one vertex moved: simple or just not
      Polygon moved = polygon;
      moved[engine() % moved.size()] = random_grid_polygon(engine, 1, 7)[0];
      ASSERT_NO_FATAL_FAILURE(compare(moved, simple));
    }
  }
  EXPECT_GT(simple, rounds / 20);
  EXPECT_LT(simple, rounds * 19 / 20);
}

TEST(ValidatePolygon, DecidesByTheLastBit) {
  // The notch's tip is on the base, or one ulp to either side of it.
  const auto notch = [](double y) { return Polygon{{0.1, 0.1}, {0.7, 0.7}, {0, 3}, {0.3, y}, {-0.5, 2}}; };
  EXPECT_NE(error_of(notch(0.3)).find("touch"), std::string::npos);
  EXPECT_EQ(error_of(notch(std::nextafter(0.3, 1.0))), "");
  EXPECT_NE(error_of(notch(std::nextafter(0.3, 0.0))).find("cross"), std::string::npos);
  for (const double far : {1e6, 1e9}) {
    const double up = std::nextafter(far, 2 * far), gap = up - far;
    EXPECT_EQ(error_of({{far, far}, {far + 4, far}, {far + 4, far + 3}, {far + 2, up}, {far, far + 3}}), "") << gap;
    EXPECT_NE(error_of({{far, far}, {far + 4, far}, {far + 4, far + 3}, {far + 2, far}, {far, far + 3}}), "");
  }
}

TEST(ValidatePolygon, CollinearVerticesAreWelcome) {
  EXPECT_EQ(error_of({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}), "");
  EXPECT_EQ(error_of({{0, 0}, {1, 1}, {2, 2}, {0, 2}}), "");
}

TEST(ValidatePolygon, ErrorsNameTheCulpritsAndARemedy) {
  EXPECT_EQ(error_of({{0, 0}, {1, 1}}),
            "P: a polygon needs at least 3 vertices, this one has 2\nhint: list the corners in order around the "
            "boundary, the first one not repeated at the end");
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_NE(error_of({{0, 0}, {1, nan}, {0, 1}}).find("vertex 1 has a coordinate that is not finite: (1, nan)"),
            std::string::npos);
  EXPECT_NE(error_of({{-inf, 0}, {1, 0}, {0, 1}}).find("vertex 0"), std::string::npos);
  for (const double bad : {1e200, -1e121, 1e-121, 5e-324}) {
    const std::string error = error_of({{0, 0}, {1, 0}, {0, bad}});
    EXPECT_NE(error.find("vertex 2 has a coordinate out of range"), std::string::npos) << error;
    EXPECT_NE(error.find("2^-400"), std::string::npos);
    EXPECT_NE(error.find("other units"), std::string::npos);
  }
  EXPECT_EQ(error_of({{0, 0}, {max_coordinate, min_coordinate}, {0, -max_coordinate}}), "");
}

TEST(ValidatePolygon, ErrorsAboutRepeatedVertices) {
  EXPECT_EQ(error_of({{0.1, 0}, {1, 0}, {0, 1}, {0.1, 0}}),
            "P: vertices 0 and 3 are the same point (0.1, 0)\nhint: leave out the last vertex: the boundary closes by "
            "itself");
  EXPECT_EQ(error_of({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
            "P: vertices 1 and 2 are the same point (1, 0)\nhint: remove one of the two");
  EXPECT_EQ(error_of({{0, 0}, {1, 0}, {2, 1}, {3, 0}, {3, 3}, {2, 1}, {0, 3}}),
            "P: vertices 2 and 5 are the same point (2, 1)\nhint: split the outline where it returns to this point, or "
            "move one of the two vertices");
  EXPECT_NE(error_of({{0, 0}, {1, 0}, {0, 1}, {-0.0, 0.0}}), "");
}

TEST(ValidatePolygon, ErrorsAboutBoundariesThatMeetThemselves) {
  EXPECT_EQ(error_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
            "P: the boundary is not simple: edges 0-1 and 2-3 cross at (1, 1)\nhint: list the vertices in order "
            "around the boundary, which must not meet itself");
  EXPECT_EQ(error_of({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}}),
            "P: the boundary is not simple: edges 0-1 and 3-4 touch: vertex 3 at (2, 0) lies on the other edge\nhint: "
            "move the vertex off the edge, or split the outline there");
  EXPECT_EQ(error_of({{0, 0}, {5, 0}, {5, 2}, {3, 0}, {2, 0}, {0, 2}}),
            "P: the boundary is not simple: edges 0-1 and 3-4 overlap from (2, 0) to (3, 0)\nhint: the two edges must "
            "not share a stretch: leave a gap between them, or drop it from the outline");
  EXPECT_EQ(
      error_of({{0, 0}, {2, 0}, {2, 2}, {2, 4}, {2, 3}, {0, 3}}),
      "P: the boundary is not simple: edges 2-3 and 3-4 overlap: the boundary folds back on itself at vertex 3 at "
      "(2, 4), from there to (2, 3)\nhint: remove the spike; it encloses no area");
  EXPECT_NE(error_of({{0, 0}, {1, 1}, {2, 2}}).find("edges 0-1 and 2-0 overlap"), std::string::npos);  // no area
  EXPECT_NE(error_of({{0, 0}, {3, 0}, {2, 0}, {1, 0}}).find("overlap"), std::string::npos);
}

double seconds_to_validate(const Polygon& polygon, std::string& error) {
  const auto start = std::chrono::steady_clock::now();
  error = error_of(polygon);
  const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ::testing::Test::RecordProperty("seconds", std::to_string(s));
  return s;
}

constexpr int million = 1000000;

Polygon large_star() {
  std::mt19937 engine(3);
  Polygon star(million);
  for (int i = 0; i < million; ++i) {
    const double r = 1 + static_cast<double>(engine()) * 0x1p-32, angle = 2 * pi * i / million;
    star[i] = {r * std::cos(angle), r * std::sin(angle)};
  }
  return star;
}

/// Long horizontal teeth: half a million edges in the status at once.
Polygon large_comb() {
  std::mt19937 engine(4);
  Polygon comb;
  for (int i = 0; i < million / 2 - 1; ++i) {
    const double tip = 1000 + static_cast<double>(engine()) * 0x1p-32, root = static_cast<double>(engine()) * 0x1p-32;
    comb.push_back({root, 2.0 * i});
    comb.push_back({tip, 2.0 * i + 1});
  }
  comb.push_back({-1, double(million)});
  comb.push_back({-1, -1});
  return comb;
}

TEST(ValidatePolygonLarge, AMillionVertices) {
  std::string error;
  Polygon ring(million);
  for (int i = 0; i < million; ++i)
    ring[i] = {1e3 * std::cos(2 * pi * i / million), 1e3 * std::sin(2 * pi * i / million)};
  const double ring_seconds = seconds_to_validate(ring, error);
  EXPECT_EQ(error, "");
  const double star_seconds = seconds_to_validate(large_star(), error);
  EXPECT_EQ(error, "");
  const double comb_seconds = seconds_to_validate(large_comb(), error);
  EXPECT_EQ(error, "");
  std::printf("a million vertices: ring %.2f s, star %.2f s, comb %.2f s\n", ring_seconds, star_seconds, comb_seconds);
}

TEST(ValidatePolygonLarge, AMillionVerticesThatAreNotSimple) {
  std::string error;
  Polygon star = large_star();
  std::swap(star[777777], star[777780]);
  const double swapped = seconds_to_validate(star, error);
  EXPECT_NE(error.find("edges 7777"), std::string::npos) << error;
  Polygon comb = large_comb();
  std::shuffle(comb.begin(), comb.end(), std::mt19937(5));
  const double shuffled = seconds_to_validate(comb, error);
  EXPECT_NE(error.find("cross at"), std::string::npos) << error;
  std::printf("a million vertices, not simple: swapped %.2f s, shuffled %.2f s\n", swapped, shuffled);
}

}  // namespace
}  // namespace taut
