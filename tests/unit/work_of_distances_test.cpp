// What questions about distances cost where doubles tell little: work is the same on every machine.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "numeric/budget.hpp"
#include "solver/pair_solver.hpp"
#include "spacetime/clearance.hpp"
#include "taut/clearance.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {
using namespace internal;
namespace {

Scene in_corpus(const char* name) { return read_scene(std::string("tests/corpus/") + name + ".json"); }

/// Far above what it takes, so that a test that fails ends.
constexpr double many_seconds = 20;

TEST(WorkOfAClearance, FarFromTheOriginAtAJoint) {
  ClearanceOptions options;
  options.limits.max_seconds = many_seconds;
  const std::uint64_t before = work_spent();
  const Clearance found = clearance(in_corpus("combs_far_from_the_origin_with_a_joint"), options);
  EXPECT_LT(work_spent() - before, 20'000u);
  ASSERT_TRUE(found.nearest) << found.reason;
  EXPECT_NEAR(found.nearest->lo, 0.02, 1e-8);
  EXPECT_NEAR(found.nearest->hi, 0.02, 1e-8);
}

void expect_profile(const char* name, double greatest, std::uint64_t limit) {
  ProfileOptions options;
  options.instants = 9;
  options.limits.max_seconds = many_seconds;
  const std::uint64_t before = work_spent();
  const DistanceProfile found = distance_profile(in_corpus(name), options);
  EXPECT_LT(work_spent() - before, limit) << name;
  ASSERT_EQ(found.reason, "") << name;
  EXPECT_LE(found.curves[0].largest_lo, greatest * (1 + 1e-12)) << name;
  EXPECT_GE(found.curves[0].largest_hi, greatest * (1 - 1e-12)) << name;
  EXPECT_LE(found.curves[0].largest_hi - found.curves[0].largest_lo, 2e-6 * greatest) << name;
}

TEST(WorkOfAProfile, ThatIsGreatestAtAnInfiniteSpeed) {
  expect_profile("greatest_distance_at_an_infinite_speed", 63.998046875, 4'000'000);
}

TEST(WorkOfAProfile, OfSliversThatSlideALittleApart) {
  expect_profile("slivers_that_slide_a_little_apart", 956, 1'000'000);
}

/// Of every pair of features that comes near a margin it is asked whether it is kept. Doubles nearly always tell, and
/// the models of the motion are shared; each search at 320 bits with models of its own took a hundred times as long.
TEST(WorkOfAProfile, OfSliversThatTurn) { expect_profile("cosine_ends_at_a_joint", 5, 6'000'000); }

/// Two edges stay within 1e-7 of each other for long, at lengths of 1: steps that tell by how much are as short as
/// that, and the walk that took them went on for more than ten minutes. It leaves the rest to margins now, and says so.
TEST(WorkOfASearch, GivesUpWhereEdgesStayAsNear) {
  const Scene scene = in_corpus("cosine_ends_at_a_joint");
  const Instance instance(scene);
  const PairInstance search(instance, 0, 1, Offset::outward);
  spacetime::Nearest nearest;
  nearest.distance = INFINITY;
  const Budget limit(Limits{many_seconds});
  const std::uint64_t before = work_spent();
  spacetime::find_nearest_within(search.geometry, search.trees(), search.segments(), 0, 1.5, {1e-6, 1e-12}, nearest);
  EXPECT_LT(work_spent() - before, 200'000u);
  EXPECT_EQ(nearest.unresolved, 0);
  EXPECT_LT(nearest.distance, 2e-7);
}

/// Slivers beside an infinite speed.
Scene slivers_beside_infinite_speed() {
  return parse_scene(R"({"format":"taut-scene/1","time":[0,1],"bodies":[
    {"name":"Q","polygon":[[-20,-6.103515625e-05],[0,-6.103515625e-05],[10,-3.0517578125e-05],[0,0],[-20,0],
                           [-10,-3.0517578125e-05]],
     "motion":{"x":[-10,0,-10],"y":[1.52587890625e-05,0,0,0,0,0,-0.0001220703125],"rotation":{"cosine":[0,-1]}}},
    {"name":"P","polygon":[[10,-3.0517578125e-05],[0,-3.0517578125e-05],[0,0],[20,0],[20,-3.0517578125e-05]],
     "motion":{"rotation":{"cosine":[1,0,-2]}}}]})");
}

TEST(WorkOfAClearance, OfSliversBesideAnInfiniteSpeed) {
  ClearanceOptions options;
  options.limits.max_seconds = many_seconds;
  const std::uint64_t before = work_spent();
  const Clearance found = clearance(slivers_beside_infinite_speed(), options);
  EXPECT_LT(work_spent() - before, 2'000'000u);
  ASSERT_TRUE(found.nearest) << found.reason;
  EXPECT_LE(found.nearest->lo, 4.5776367e-5);
  EXPECT_GE(found.nearest->hi, 4.5776347e-5);
}

/// What is known when a limit ends the search is said, and that it is not what was asked for.
TEST(WorkOfAClearance, WhatALimitLeavesWideIsSaidToBe) {
  int brackets = 0;
  for (const double seconds : {0.003, 0.01, 0.03, 0.1, 0.3}) {
    ClearanceOptions options;
    options.limits.max_seconds = seconds;
    const Clearance found = clearance(slivers_beside_infinite_speed(), options);
    ASSERT_NE(found.nearest.has_value(), !found.reason.empty());
    if (!found.nearest) continue;
    ++brackets;
    EXPECT_LE(found.nearest->lo, 4.5776367e-5);
    EXPECT_GE(found.nearest->hi, 4.5776347e-5);
    const bool narrow = found.nearest->hi - found.nearest->lo <= 2e-9 * found.nearest->hi;
    EXPECT_EQ(found.wide.empty(), narrow) << found.wide;
  }
  if (brackets == 0) GTEST_SKIP() << "so slow that not even a first bracket was there";
}

/// Coordinates of 2^34 leave a distance of 1.5 to two digits: what was asked for cannot be had, and the answer says so.
TEST(WorkOfAClearance, WhatCoordinatesLeaveWideIsSaidToBe) {
  const double far = 0x1p34;
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"near", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}},
                  {"far", {{far, 0}, {far + 1, 0}, {far + 1, 1}, {far, 1}}, from_velocity({0.25, 0})}};
  scene.bodies[1].motion.pieces[0].x = {2.5 - far, 0.25};
  const Clearance found = clearance(scene);
  ASSERT_TRUE(found.nearest);
  EXPECT_LE(found.nearest->lo, 1.5);
  EXPECT_GE(found.nearest->hi, 1.5);
  EXPECT_GT(found.nearest->hi - found.nearest->lo, 1e-3);
  EXPECT_NE(found.wide.find("largest coordinate"), std::string::npos) << found.wide;
  scene.bodies[1].polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene.bodies[1].motion.pieces[0].x = {2.5, 0.25};
  EXPECT_EQ(clearance(scene).wide, "");
}

}  // namespace
}  // namespace taut
