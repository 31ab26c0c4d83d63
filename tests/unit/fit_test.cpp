// Bodies shrunk a little before they are asked about.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "scene/fitted_scene.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
namespace {

Polygon block(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

Scene two(const Polygon& first, const Polygon& second) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"first", first, {}}, {"second", second, {}}};
  return scene;
}

Answer with_fit(const Scene& scene, double fit) {
  CheckOptions options;
  options.fit = fit;
  return check(scene, options);
}

TEST(Fit, OverlapsByRoundingAreNone) {
  // 0.1 + 0.2 is not 0.3.
  const Scene scene = two(block(0, 0, 0.1 + 0.2, 1), block(0.3, 0, 1, 1));
  EXPECT_EQ(check(scene).outcome, Outcome::overlap_at_start);
  const Answer fitted = with_fit(scene, 1e-9);
  EXPECT_EQ(fitted.outcome, Outcome::free);
  EXPECT_EQ(fitted.fit, 1e-9);
  // A real overlap stays one.
  EXPECT_EQ(with_fit(two(block(0, 0, 0.31, 1), block(0.3, 0, 1, 1)), 1e-9).outcome, Outcome::overlap_at_start);
  // cos 90 degrees is 6e-17.
  Scene turned = two(block(0, -1, 4, 1), block(0, 0, 1, 1));
  turned.bodies[1].motion.pieces = {{{1}, {}, AngleRotation{{1.5707963267948966}}}};
  EXPECT_EQ(with_fit(turned, 1e-9).outcome, Outcome::free);
}

/// How far p is to the left of the line from a to b.
double left_of(const Point& a, const Point& b, const Point& p) {
  return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
}

double twice_area_of(const Polygon& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

/// Every edge has moved towards the material by between the fit and twice as much, at both ends.
void expect_moved(const Polygon& given, const Polygon& shrunk, bool hole, double fit) {
  ASSERT_EQ(given.size(), shrunk.size());
  const double side = (twice_area_of(given) > 0) != hole ? 1 : -1;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::size_t next = (i + 1) % given.size();
    for (const std::size_t end : {i, next}) {
      const double moved = side * left_of(given[i], given[next], shrunk[end]);
      EXPECT_GE(moved, fit * (1 - 1e-6));
      EXPECT_LE(moved, 2 * fit * (1 + 1e-6));
    }
  }
}

TEST(Fit, MovesEveryEdgeByBetweenOnceAndTwice) {
  int rings = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < effort(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = scene_of(random_world(seed));
    const double fit = std::ldexp(1.0, -4 - static_cast<int>(seed % 16));
    Scene small;
    try {
      small = FittedScene(scene, fit).scene();
    } catch (const InputError&) {
      ++refused;
      continue;
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body &given = scene.bodies[i], &shrunk = small.bodies[i];
      // Parts that touch or overlap are shrunk as one shape: tests/property/union_test.cpp.
      if (joined_parts(given, 0, fit / 64)) continue;
      if (given.parts.empty()) {
        expect_moved(given.polygon, shrunk.polygon, false, fit);
        ++rings;
      }
      for (std::size_t k = 0; k < given.parts.size(); ++k) {
        expect_moved(given.parts[k].outline, shrunk.parts[k].outline, false, fit);
        for (std::size_t h = 0; h < given.parts[k].holes.size(); ++h, ++rings)
          expect_moved(given.parts[k].holes[h], shrunk.parts[k].holes[h], true, fit);
      }
    }
  }
  EXPECT_GE(rings, static_cast<int>(enough(200)));
  EXPECT_GE(refused, static_cast<int>(enough(1)));
}

/// A waist that is thinner than what is taken off on both sides: the ring would meet itself, not close to where it was.
TEST(Fit, RefusesWhatWouldMeetItself) {
  const Polygon waist{{0, 0}, {2.13, 0}, {1.07, 0.97}, {1.13, 1.03}, {2.17, 2}, {0, 2}, {1.01, 1.03}, {1.01, 0.97}};
  EXPECT_NO_THROW(FittedScene(two(waist, block(9, 0, 1, 1)), 0.01));
  for (const double fit : {0.05, 0.1, 0.2})
    EXPECT_THROW(FittedScene(two(waist, block(9, 0, 1, 1)), fit), InputError) << fit;
}

/// What is free stays free, and the gap grows by between two and four fits where faces look at each other.
TEST(Fit, GapsGrow) {
  const Scene scene = two(block(0, 0, 1, 1), block(1.5, 0, 1, 1));
  const double fit = 0.01, before = clearance(scene).nearest->hi,
               after = clearance(FittedScene(scene, fit).scene()).nearest->hi;
  EXPECT_GE(after, before + 2 * fit * (1 - 1e-6));
  EXPECT_LE(after, before + 4 * fit * (1 + 1e-6));
}

std::string refusal(const Scene& scene, double fit) {
  try {
    with_fit(scene, fit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(Fit, RefusesWithThePlace) {
  const Scene scene =
      two({{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 0.9}, {1.99, 0.9}, {1.99, 1}, {0, 1}}, block(9, 0, 1, 1));
  EXPECT_EQ(with_fit(scene, 1e-3).outcome, Outcome::free);
  const std::string fine = refusal(scene, 0.6);
  EXPECT_NE(fine.find("first: "), std::string::npos) << fine;
  EXPECT_NE(fine.find("for a fit of 0.6"), std::string::npos) << fine;
  EXPECT_NE(refusal(scene, -1).find("fit: it is not a positive number"), std::string::npos);
  EXPECT_NE(refusal(scene, 1e-15).find("less than 2^-40"), std::string::npos);
  Scene thin = scene;
  thin.bodies[1].polygon.clear();
  thin.bodies[1].parts = {{block(9, 0, 4, 4), {block(9.05, 1, 3, 2)}}};
  EXPECT_EQ(with_fit(thin, 1e-3).outcome, Outcome::free);
  EXPECT_NE(refusal(thin, 0.04).find("shrunk by a fit of 0.04"), std::string::npos) << refusal(thin, 0.04);
  CheckOptions options;
  options.fit = 1e-3;
  std::ostringstream log;
  EXPECT_THROW(prove(scene, log, options), InputError);
}

}  // namespace
}  // namespace taut::testing
