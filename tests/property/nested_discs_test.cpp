// Bodies in holes of others: discs that decide at once must not decide what boxes and tilings deny.
#include "spacetime/any_rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/displacement.hpp"
#include "scene/ring_set.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/motions.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
namespace {

using internal::DisplacedPoint;
using internal::spacetime::Disc;

/// About a middle, with radii between those shares of the radius.
Polygon wheel(Rng& rng, const Point& middle, double radius, double least) {
  const int n = rng.between(3, 24);
  const double phase = rng.real(0, 6.3);
  Polygon ring;
  for (int i = 0; i < n; ++i) {
    const double angle = phase + 6.283185307179586 * i / n, far = radius * rng.real(least, 1);
    ring.push_back({middle.x + far * std::cos(angle), middle.y + far * std::sin(angle)});
  }
  return ring;
}

TEST(NestedDiscs, HoldWhatTheySay) {
  int within = 0;
  for (std::uint64_t seed = 0; seed < effort(2000); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Polygon ring = wheel(rng, {rng.real(-0.5, 0.5), rng.real(-0.5, 0.5)}, 0.4, rng.chance(0.5) ? 1 : 0.3);
    std::vector<DisplacedPoint> points;
    for (const Point& p : ring) points.push_back({p.x, p.y, 0, 0});
    const Disc around = internal::spacetime::disc_around(points), hollow = internal::spacetime::disc_within(points);
    const auto from = [](const Disc& disc, const Point& p) {
      return std::hypot(p.x - disc.centre.x, p.y - disc.centre.y);
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      EXPECT_LT(from(around, a), around.radius);
      for (int k = 0; k <= 200; ++k) {
        const double s = k / 200.0;
        const double away = from(hollow, {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
        EXPECT_TRUE(hollow.radius == 0 || away > hollow.radius);
      }
    }
    // No three of the points need a larger disc than all of them.
    for (int k = 0; k < 20; ++k) {
      const auto any = [&] { return points[static_cast<std::size_t>(rng.below(static_cast<int>(points.size())))]; };
      EXPECT_LE(internal::spacetime::disc_around(std::vector{any(), any(), any()}).radius, around.radius * (1 + 1e-9));
    }
    within += hollow.radius > 0 ? 1 : 0;
  }
  EXPECT_GT(within, static_cast<int>(enough(1500)));
}

/// A pin in a bore, with a gap of any size, that turns about nearly its middle and moves by about the gap.
Scene pin_in_bore(Rng& rng) {
  const Point middle{rng.real(-3, 3), rng.real(-3, 3)}, drawn{rng.real(-3, 3), rng.real(-3, 3)};
  const double gap = std::pow(10.0, -rng.real(0.5, 6));
  Part plate;
  plate.outline = {{middle.x - 2, middle.y - 2},
                   {middle.x + 2, middle.y - 2},
                   {middle.x + 2, middle.y + 2},
                   {middle.x - 2, middle.y + 2}};
  const int n = rng.between(3, 40);
  Polygon hole;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n, far = 1 / std::cos(3.14159265358979 / n);
    hole.push_back({middle.x + far * std::cos(angle), middle.y + far * std::sin(angle)});
  }
  plate.holes = {hole};
  Body bore, pin;
  bore.name = "bore";
  bore.parts = {plate};
  pin.name = "pin";
  pin.polygon = wheel(rng, drawn, 1 - gap, rng.chance(0.5) ? 1 : 0.5);
  const auto off = [&](double most) { return rng.chance(0.3) ? 0 : gap * rng.real(-most, most); };
  const double dx = middle.x - drawn.x, dy = middle.y - drawn.y, turn = rng.chance(0.2) ? 0 : rng.real(-400, 400);
  std::vector<Keyframe> frames{{0, dx + off(0.7), dy + off(0.7), 0}, {1, dx + off(2.5), dy + off(2.5), turn}};
  pin.motion = from_keyframes(frames, drawn);
  Scene scene;
  scene.bodies = {bore, pin};
  if (rng.chance(0.5)) std::swap(scene.bodies[0], scene.bodies[1]);
  scene.start = 0;
  scene.end = 1;
  return scene;
}

TEST(NestedDiscs, EnginesAgreeOnPinsInBores) {
  int free = 0, contacts = 0;
  for (std::uint64_t seed = 0; seed < effort(600); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene scene = pin_in_bore(rng);
    CheckOptions options;
    options.touch = rng.chance(0.5) ? Touch::open : Touch::closed;
    options.engine = EngineChoice::both;
    const Outcome outcome = check(scene, options).outcome;
    free += outcome == Outcome::free ? 1 : 0;
    contacts += outcome == Outcome::contact ? 1 : 0;
  }
  EXPECT_GT(free, static_cast<int>(enough(100)));
  EXPECT_GT(contacts, static_cast<int>(enough(100)));
}

/// Of a vertex from the other body's edges, as sampled.
double sampled_distance(const Scene& scene, double t) {
  const auto rings = [&](const Body& body) {
    std::vector<Polygon> out;
    for (const Part& part : internal::parts_of(body)) {
      out.push_back(part.outline);
      out.insert(out.end(), part.holes.begin(), part.holes.end());
    }
    const BodyPose pose = pose_at(body.motion, t);
    for (Polygon& ring : out) {
      for (Point& p : ring)
        p = {pose.origin.x + pose.axis.x * p.x - pose.axis.y * p.y,
             pose.origin.y + pose.axis.y * p.x + pose.axis.x * p.y};
    }
    return out;
  };
  const auto to_edges = [](const std::vector<Polygon>& vertices, const std::vector<Polygon>& edges) {
    double least = INFINITY;
    for (const Polygon& from : vertices) {
      for (const Point& p : from) {
        for (const Polygon& ring : edges) {
          for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            const double ex = b.x - a.x, ey = b.y - a.y;
            const double s = std::clamp(((p.x - a.x) * ex + (p.y - a.y) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
            least = std::min(least, std::hypot(p.x - a.x - s * ex, p.y - a.y - s * ey));
          }
        }
      }
    }
    return least;
  };
  const auto a = rings(scene.bodies[0]), b = rings(scene.bodies[1]);
  return std::min(to_edges(a, b), to_edges(b, a));
}

TEST(NestedDiscs, ClearanceIsNotMoreThanSamplesShow) {
  int asked = 0;
  for (std::uint64_t seed = 10000; seed < 10000 + effort(200); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene scene = pin_in_bore(rng);
    ClearanceOptions options;
    options.relative = 1e-4;
    const Clearance found = clearance(scene, options);
    if (found.outcome != Outcome::free) continue;
    ++asked;
    double least = INFINITY;
    for (int k = 0; k <= 300; ++k) least = std::min(least, sampled_distance(scene, k / 300.0));
    EXPECT_LE(found.nearest->lo, least + 1e-12);
    EXPECT_NEAR(sampled_distance(scene, found.nearest->time.lo), found.nearest->hi, 1e-3 * found.nearest->hi + 1e-11);
  }
  EXPECT_GT(asked, static_cast<int>(enough(40)));
}

}  // namespace
}  // namespace taut::testing
