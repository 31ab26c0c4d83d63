// Regions that bodies pass over, against thousands of poses by arithmetic of their own, and against check(): the body
// never meets what is outside.
#include "taut/swept.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
namespace {

bool inside_ring(const Polygon& ring, const Complex& p) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    if ((a.y > p.imag()) != (b.y > p.imag()) && p.real() < a.x + (p.imag() - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

bool in_region(const SweptRegion& region, const Complex& p) {
  return std::any_of(region.parts.begin(), region.parts.end(), [&](const Part& part) {
    return inside_ring(part.outline, p) && std::none_of(part.holes.begin(), part.holes.end(),
                                                        [&](const Polygon& hole) { return inside_ring(hole, p); });
  });
}

double to_body(const BodyAtPose& body, const Complex& p) {
  double least = INFINITY;
  for (const PartAtPose& part : body) {
    bool inside = false;
    for (const RingAtPose& ring : part.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Complex &a = ring[k], &b = ring[(k + 1) % ring.size()];
        least = std::min(least, to_segment(p, a, b));
        if ((a.imag() > p.imag()) != (b.imag() > p.imag()) &&
            p.real() < a.real() + (p.imag() - a.imag()) / (b.imag() - a.imag()) * (b.real() - a.real()))
          inside = !inside;
      }
    }
    if (inside) return 0;
  }
  return least;
}

/// The boundary, and places in the inside, of a region.
std::vector<Complex> places_in(Rng& rng, const SweptRegion& region) {
  std::vector<Complex> places;
  Complex low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  const auto add_ring = [&](const Polygon& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
      low = {std::min(low.real(), a.x), std::min(low.imag(), a.y)};
      high = {std::max(high.real(), a.x), std::max(high.imag(), a.y)};
      if (!rng.chance(std::min(1.0, 60.0 / static_cast<double>(ring.size())))) continue;
      places.emplace_back(a.x, a.y);
      places.emplace_back((a.x + b.x) / 2, (a.y + b.y) / 2);
    }
  };
  for (const Part& part : region.parts) {
    add_ring(part.outline);
    for (const Polygon& hole : part.holes) add_ring(hole);
  }
  for (int k = 0; k < 200; ++k) {
    const Complex p(rng.real(low.real(), high.real()), rng.real(low.imag(), high.imag()));
    if (in_region(region, p)) places.push_back(p);
  }
  return places;
}

TEST(Swept, AsThousandsOfPosesSay) {
  int holes = 0;
  for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const MadeWorld world = random_way(rng);
    const int body = static_cast<int>(world.bodies.size()) - 1;
    SweptOptions options;
    options.tolerance = std::ldexp(rng.real(1, 2), -rng.between(4, 10));
    const SweptRegion region = swept(scene_of(world), body, options);
    for (const Part& part : region.parts) holes += static_cast<int>(part.holes.size());
    const std::vector<Complex> places = places_in(rng, region);
    std::vector<double> nearest(places.size(), INFINITY);
    constexpr int poses = 4000;
    double step = 0;
    BodyAtPose before;
    for (int k = 0; k <= poses; ++k) {
      const BodyAtPose at = posed(world, body, world.end * k / poses);
      for (std::size_t part = 0; part < at.size(); ++part) {
        for (std::size_t r = 0; r < at[part].rings.size(); ++r) {
          const RingAtPose& ring = at[part].rings[r];
          for (std::size_t v = 0; v < ring.size(); ++v) {
            if (k > 0) step = std::max(step, std::abs(ring[v] - before[part].rings[r][v]));
            if (k % 10 != 0) continue;
            const double share = rng.real(0, 1);
            ASSERT_TRUE(in_region(region, ring[v]));
            ASSERT_TRUE(in_region(region, share * ring[v] + (1 - share) * ring[(v + 1) % ring.size()]));
          }
        }
      }
      for (std::size_t p = 0; p < places.size(); ++p) {
        if (nearest[p] > options.tolerance / 2) nearest[p] = std::min(nearest[p], to_body(at, places[p]));
      }
      before = at;
    }
    // Between two poses a body goes no farther than a step.
    for (std::size_t p = 0; p < places.size(); ++p) ASSERT_LE(nearest[p], options.tolerance + step / 2) << places[p];
  }
  EXPECT_GE(holes, enough(5));
}

/// All but the region, within a frame.
Body outside_of(const SweptRegion& region) {
  constexpr double far = 64;
  Body outside;
  outside.name = "outside";
  Part around{{{-far, -far}, {far, -far}, {far, far}, {-far, far}}, {}};
  for (const Part& part : region.parts) {
    around.holes.push_back(part.outline);
    for (const Polygon& hole : part.holes) outside.parts.push_back({hole, {}});
  }
  outside.parts.push_back(around);
  return outside;
}

TEST(Swept, CertainlyHoldsTheBody) {
  int proved = 0;
  for (std::uint64_t seed = 0; seed < effort(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const MadeWorld world = random_way(rng);
    const int body = static_cast<int>(world.bodies.size()) - 1;
    Scene scene = scene_of(world);
    SweptOptions options;
    options.tolerance = std::ldexp(rng.real(1, 2), -rng.between(3, 6));
    const SweptRegion region = swept(scene, body, options);
    // Parts that touch are two holes with a common side.
    if (region.parts.size() > 1) continue;
    scene.bodies.push_back(outside_of(region));
    for (int k = 0; k < body; ++k) scene.ignore.push_back({scene.bodies[static_cast<std::size_t>(k)].name, "*"});
    CheckOptions ask;
    ask.touch = Touch::closed;
    const Answer answer = check(scene, ask);
    EXPECT_STREQ(to_string(answer.outcome), "free");
    ++proved;
  }
  EXPECT_GE(proved, enough(15));
}

Scene moved(const Polygon& outline, Motion motion, double end) {
  Scene scene;
  scene.end = end;
  scene.bodies = {{"body", outline, std::move(motion)}};
  return scene;
}

TEST(Swept, AreasThatAreKnown) {
  constexpr double pi = 3.14159265358979323846;
  const Polygon bar{{-1, -0.125}, {1, -0.125}, {1, 0.125}, {-1, 0.125}};
  const double reach = std::hypot(1, 0.125);
  // A disc; a million turns cost as much as one.
  for (const double turns : {0.5 + 0.1, 1.0, 1e6}) {
    const SweptRegion disc = swept(moved(bar, from_velocity({0, 0}, 360), turns), 0, {1e-3, {}});
    ASSERT_EQ(disc.parts.size(), 1u);
    EXPECT_TRUE(disc.parts[0].holes.empty());
    EXPECT_GE(disc.area, pi * reach * reach);
    EXPECT_LE(disc.area, pi * (reach + 1e-3) * (reach + 1e-3));
  }
  // A ring: the bar is off the centre of its turn.
  const Polygon off{{2, -0.125}, {3, -0.125}, {3, 0.125}, {2, 0.125}};
  const SweptRegion ring = swept(moved(off, from_velocity({0, 0}, 360), 1), 0, {1e-3, {}});
  ASSERT_EQ(ring.parts.size(), 1u);
  ASSERT_EQ(ring.parts[0].holes.size(), 1u);
  const double outer = std::hypot(3, 0.125);
  EXPECT_GE(ring.area, pi * (outer * outer - 4));
  EXPECT_LE(ring.area, pi * ((outer + 1e-3) * (outer + 1e-3) - (2 - 1e-3) * (2 - 1e-3)));
  // Straight: a square that moves by 3, and one at rest.
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_NEAR(swept(moved(square, from_velocity({3, 0}), 1), 0, {1e-4, {}}).area, 4, 1e-3);
  EXPECT_NEAR(swept(moved(square, {}, 1), 0, {1e-4, {}}).area, 1, 4e-4);
  // A cosine that begins with infinite speed: a quarter turn.
  Motion fast;
  fast.pieces = {{{}, {}, CosineRotation{{1, -1}}}};
  const SweptRegion quarter = swept(moved({{0, -1e-3}, {1, -1e-3}, {1, 1e-3}, {0, 1e-3}}, fast, 1), 0, {1e-2, {}});
  EXPECT_NEAR(quarter.area, pi / 4, 0.03);
}

TEST(Swept, CurvesAreWithinPolygonsAroundThem) {
  constexpr double pi = 3.14159265358979323846;
  const Scene scene = parse_scene(R"({"format": "taut-scene/1", "time": [0, 1], "bodies": [
      {"name": "disc", "polygon": {"path": "M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"}, "motion": {"velocity": [3, 0]}}]})");
  const SweptRegion region = swept(scene, 0, {1e-2, {}});
  EXPECT_GE(region.area, pi + 6);
  EXPECT_LE(region.area, pi * 1.01 * 1.01 + 6.06);
}

/// To a millimetre, where maps of countries have their coordinates.
TEST(Swept, FarFromTheOrigin) {
  constexpr double pi = 3.14159265358979323846;
  const Scene scene = parse_scene(R"({"format": "taut-scene/1", "time": [0, 1], "bodies": [
      {"name": "gate", "polygon": [[5334000, 691608], [5334003, 691608], [5334003, 691608.125], [5334000, 691608.125]],
       "motion": {"sweep": {"pivot": [5334000, 691608], "from_deg": 0, "to_deg": 90}}},
      {"name": "cart", "polygon": [[5334000, 691608], [5334002, 691608], [5334002, 691609], [5334000, 691609]],
       "motion": {"velocity": [30, 0]}}]})");
  const SweptRegion gate = swept(scene, 0, {1e-3, {}}), cart = swept(scene, 1, {1e-3, {}});
  // About a corner, every radius up to the diagonal covers a quarter of a turn more than the gate has of it.
  const double area = pi / 4 * (3 * 3 + 0.125 * 0.125) + 3 * 0.125;
  EXPECT_GE(gate.area, area);
  EXPECT_LE(gate.area, area + 1e-3 * 12);
  EXPECT_GE(cart.area, 32);
  EXPECT_LE(cart.area, (32 + 2e-3) * (1 + 2e-3));
  for (const Complex& p : {Complex(5334000, 691608), Complex(5334032, 691608), Complex(5334032, 691609)})
    EXPECT_TRUE(in_region(cart, p));
}

TEST(Swept, SaysWhatItCannotDo) {
  const Scene scene = moved({{0, 0}, {1, 0}, {0, 1}}, from_velocity({1, 0}), 1);
  EXPECT_THROW(swept(scene, 1), InputError);
  EXPECT_THROW(swept(scene, 0, {-1, {}}), InputError);
  EXPECT_THROW(swept(scene, 0, {1e-12, {}}), InputError);
  SweptOptions stopped;
  stopped.limits.max_seconds = 0;
  EXPECT_THROW(swept(scene, 0, stopped), UndecidedError);
}

}  // namespace
}  // namespace taut::testing
