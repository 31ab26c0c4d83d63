// Contests as libraries see them: the scaled shapes at their relative poses are the bodies, moved and scaled.
#include "peers/peer_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/pose.hpp"

namespace taut::bench {
namespace {

Contest contest_named(const std::string& name, int n) {
  for (const ContestFamily& family : contest_families()) {
    if (family.name == name) return family.make(n);
  }
  throw std::logic_error("no family " + name);
}

Point placed(const BodyPose& pose, const Point& p) {
  return {pose.origin.x + p.x * pose.axis.x - p.y * pose.axis.y, pose.origin.y + p.x * pose.axis.y + p.y * pose.axis.x};
}

/// Distances between vertices of one body and of the other are the scene's, times one factor. (All polygons here are
/// counterclockwise, so that indices are the same.)
void expect_same_distances(const Contest& contest, const Motion& second, double t) {
  const PeerPair pair(contest);
  const std::vector<Body>& bodies = contest.scene.bodies;
  const BodyPose a = pose_at(bodies[0].motion, t), b = pose_at(second, t);
  const bool swapped = pair.fixed_body() == 1;
  const PeerShape& first_shape = swapped ? pair.moving() : pair.fixed();
  const PeerShape& second_shape = swapped ? pair.fixed() : pair.moving();
  const RelativePose pose = pair.pose(t);
  double factor = 0;
  for (std::size_t k = 0; k < 20; ++k) {
    const std::size_t i = k * 7 % bodies[0].polygon.size(), j = k * 11 % bodies[1].polygon.size();
    const Point p = placed(a, bodies[0].polygon[i]), q = placed(b, bodies[1].polygon[j]);
    Point u = first_shape.outline[i], v = second_shape.outline[j];
    Point& moved = swapped ? u : v;
    moved = {pose.x + moved.x * pose.c - moved.y * pose.s, pose.y + moved.x * pose.s + moved.y * pose.c};
    const double scene = std::hypot(p.x - q.x, p.y - q.y), metres = std::hypot(u.x - v.x, u.y - v.y);
    if (k == 0) factor = metres / scene;
    ASSERT_NEAR(metres, factor * scene, 1e-9 * (1 + metres));
  }
}

TEST(PeerPair, SameDistances) {
  for (const char* name : {"gears", "dips", "far", "spiral", "octagons", "bay"}) {
    SCOPED_TRACE(name);
    const Contest contest = contest_named(name, 128);
    for (const double share : {0.0, 0.3, 0.9}) {
      const double t = contest.scene.start + share * (contest.scene.end - contest.scene.start);
      ASSERT_NO_FATAL_FAILURE(expect_same_distances(contest, contest.scene.bodies[1].motion, t));
    }
  }
}

TEST(PeerPair, TheFixedOneHasMoreVertices) {
  EXPECT_EQ(PeerPair(contest_named("dips", 128)).fixed_body(), 1u);
  EXPECT_EQ(PeerPair(contest_named("combs, hit", 64)).fixed_body(), 0u);
}

TEST(PeerPair, FollowsPlans) {
  const Contest contest = contest_named("plans", 64);
  for (const int k : {0, 1, 57, 199})
    ASSERT_NO_FATAL_FAILURE(expect_same_distances(contest, contest.plans[static_cast<std::size_t>(k)], k + 0.25));
}

TEST(PeerPair, Sizes) {
  const Contest contest = contest_named("far", 64);
  const PeerPair pair(contest);
  double extent = 0;
  for (const PeerShape* shape : {&pair.fixed(), &pair.moving()}) {
    for (const Point& p : shape->outline) {
      extent = std::max({extent, 2 * std::fabs(p.x), 2 * std::fabs(p.y)});
      ASSERT_LE(std::hypot(p.x, p.y), shape->radius);
    }
    for (const Polygon& piece : shape->pieces) ASSERT_LE(piece.size(), peer_vertices);
  }
  EXPECT_NEAR(extent, peer_size, 1e-12);
}

TEST(PeerPair, StraightMotions) {
  EXPECT_TRUE(is_straight(contest_named("octagons", 8)));
  EXPECT_TRUE(is_straight(contest_named("far", 64)));
  for (const char* name : {"gears", "dips", "dips_linear", "plans"})
    EXPECT_FALSE(is_straight(contest_named(name, 64))) << name;
}

TEST(SampleTimes, FromStartToEnd) {
  Contest contest = contest_named("octagons", 8);
  contest.scene.start = 2;
  contest.scene.end = 4;
  EXPECT_EQ(sample_times(contest, 4), (std::vector<double>{2, 2.5, 3, 3.5, 4}));
}

}  // namespace
}  // namespace taut::bench
