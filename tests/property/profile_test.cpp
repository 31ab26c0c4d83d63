// The distance over time against closed forms, and against the distance of posed bodies by definition.
#include <gtest/gtest.h>

#include <cmath>

#include "support/effort.hpp"
#include "support/large_world.hpp"
#include "support/world_judge.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
namespace {

const Polygon unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Scene profile_scene(const Motion& motion, double end) {
  Scene scene;
  scene.end = end;
  scene.bodies.resize(2);
  scene.bodies[0].name = "rests";
  scene.bodies[0].polygon = unit_square;
  scene.bodies[1].name = "moves";
  scene.bodies[1].polygon = unit_square;
  scene.bodies[1].motion = motion;
  return scene;
}

void expect_bracket(double lo, double hi, double true_value, double width) {
  EXPECT_LE(lo, true_value + 1e-15);
  EXPECT_GE(hi, true_value - 1e-15);
  EXPECT_LE(hi - lo, width);
}

/// Past the resting square's corner and away: d = |1 + t| on a straight way, and the greatest at the end.
TEST(DistanceProfile, AlongALine) {
  Motion motion;
  motion.pieces.resize(1);
  motion.pieces[0].x = {2, 1};
  ProfileOptions options;
  options.instants = 5;
  const DistanceProfile answer = distance_profile(profile_scene(motion, 2), options);
  ASSERT_EQ(answer.curves.size(), 1u);
  const DistanceCurve& c = answer.curves[0];
  ASSERT_EQ(c.instants.size(), 5u);
  for (const DistanceAt& d : c.instants) expect_bracket(d.lo, d.hi, 1 + d.t, 1e-8);
  ASSERT_EQ(c.stretches.size(), 4u);
  for (const DistanceWithin& s : c.stretches) {
    EXPECT_LE(s.lo, 1 + s.from);
    EXPECT_GE(s.lo, 1 + s.from - 1e-8);
    EXPECT_GE(s.hi, 1 + s.to);
    EXPECT_LE(s.hi, 1.03 * (1 + s.to));
  }
  EXPECT_TRUE(c.settled);
  expect_bracket(c.largest_lo, c.largest_hi, 3, 4e-9);
  EXPECT_EQ(c.largest_at, 2);
}

/// There, through the other one, and back: 0 while they overlap, the greatest in between.
TEST(DistanceProfile, ThroughAnOverlapAndBack) {
  std::vector<Keyframe> way(4);
  const double x[] = {-2, 3, 1.5, 3}, t[] = {0, 5, 6.5, 8};
  for (std::size_t i = 0; i < 4; ++i) way[i] = {t[i], x[i], 0.25, 0};
  ProfileOptions options;
  options.instants = 9;
  const DistanceProfile answer = distance_profile(profile_scene(from_keyframes(way), 8), options);
  const DistanceCurve& c = answer.curves.at(0);
  const double want[] = {1, 0, 0, 0, 1, 2, 1, 1, 2};
  for (std::size_t i = 0; i < 9; ++i) expect_bracket(c.instants[i].lo, c.instants[i].hi, want[i], 1e-8);
  EXPECT_EQ(c.instants[2].hi, 0);
  // From the first touch, which has 0 as its lower end, to the last.
  EXPECT_EQ(c.stretches[0].lo, 0);
  EXPECT_EQ(c.stretches[1].hi, 0);
  expect_bracket(c.largest_lo, c.largest_hi, 2, 3e-9);
  EXPECT_NEAR(c.largest_at, c.largest_at < 6.5 ? 5 : 8, 1e-6);
}

/// A square that turns about its middle: its corner's way to the wall is a cosine, the greatest where a face is
/// parallel.
TEST(DistanceProfile, OfATurn) {
  Scene scene = profile_scene({}, 1);
  scene.bodies[0].polygon = {{2, -9}, {3, -9}, {3, 9}, {2, 9}};
  scene.bodies[1].polygon = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  scene.bodies[1].motion.pieces.resize(1);
  scene.bodies[1].motion.pieces[0].rotation = AngleRotation{{0.5, 1}};
  ProfileOptions options;
  options.instants = 33;
  const DistanceProfile answer = distance_profile(scene, options);
  const DistanceCurve& c = answer.curves.at(0);
  const double quarter = std::acos(-1.0) / 4;
  for (const DistanceAt& d : c.instants) {
    const double angle = std::fabs(std::remainder(0.5 + d.t - quarter, 2 * quarter));
    expect_bracket(d.lo, d.hi, 2 - std::sqrt(2.0) * std::cos(angle), 1e-8);
  }
  EXPECT_TRUE(c.settled);
  const double angle = std::fabs(std::remainder(1.5 - quarter, 2 * quarter));
  expect_bracket(c.largest_lo, c.largest_hi, 2 - std::sqrt(2.0) * std::cos(angle), 1e-8);
}

TEST(DistanceProfile, OfWorldsByDefinition) {
  int curves = 0, settled = 0;
  for (std::uint64_t seed = 0; seed < effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MadeWorld world = random_world(seed);
    ProfileOptions options;
    options.instants = 7;
    options.relative = 1e-6;
    options.halvings = 300;
    options.all_pairs = true;
    const DistanceProfile answer = distance_profile(scene_of(world), options);
    ASSERT_EQ(answer.reason, "");
    WorldJudge judge(world, 40);
    for (const DistanceCurve& c : answer.curves) {
      if (!c.pair) continue;
      EXPECT_EQ(judge.curve_fault(*c.pair, c), "");
      ++curves;
      settled += c.settled;
    }
    // The least of all pairs at each instant.
    if (answer.curves.size() < 2) continue;
    for (std::size_t k = 0; k < 7; ++k) {
      double lo = INFINITY, hi = INFINITY;
      for (std::size_t i = 1; i < answer.curves.size(); ++i) {
        lo = std::min(lo, answer.curves[i].instants[k].lo);
        hi = std::min(hi, answer.curves[i].instants[k].hi);
      }
      const DistanceAt& d = answer.curves[0].instants[k];
      EXPECT_LE(d.lo, hi);
      EXPECT_GE(d.hi, lo);
    }
  }
  EXPECT_GE(curves, static_cast<int>(enough(600)));
  EXPECT_GE(settled, curves * 9 / 10);
}

TEST(DistanceProfile, ALimitIsSaid) {
  Motion turning;
  turning.pieces.resize(1);
  turning.pieces[0].x = {3};
  turning.pieces[0].rotation = AngleRotation{{0, 1}};
  ProfileOptions options;
  options.instants = 2;
  options.halvings = 3;
  const DistanceCurve c = distance_profile(profile_scene(turning, 3), options).curves.at(0);
  EXPECT_FALSE(c.settled);
  EXPECT_LT(c.largest_lo, c.largest_hi);
  options.instants = 1;
  EXPECT_THROW(distance_profile(profile_scene(turning, 3), options), InputError);
  options.instants = 2;
  options.limits.max_seconds = 0;
  EXPECT_NE(distance_profile(profile_scene(turning, 3), options).reason, "");
}

}  // namespace
}  // namespace taut::testing
